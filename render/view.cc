// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <stdexcept>

#include "render/views/views.h"

namespace loopscope {
namespace {

void RequireLayers(const ViewRequest& request) {
  if (!request.layers) return;
  const std::set<LayerKind>& all = LayersOf(request.view);
  for (const LayerKind kind : *request.layers) {
    if (all.count(kind) > 0) continue;
    std::string expected;
    for (const LayerKind known : all) expected += (expected.empty() ? "" : ", ") + ToString(known);
    throw std::invalid_argument("view " + ToString(request.view) + " has no layer '" +
                                ToString(kind) + "': expected some of " + expected);
  }
}

void RequireCamera(const ViewRequest& request) {
  if (request.view == ViewKind::kChart && (request.center || request.width_in_meters)) {
    throw std::invalid_argument("view chart has no map: expected no center and no width of it");
  }
  if (request.width_in_meters && !(*request.width_in_meters > 0.0)) {
    throw std::invalid_argument("width of the map is " + std::to_string(*request.width_in_meters) +
                                " m: expected more than 0");
  }
}

void RequireSide(const ViewRequest& request) {
  if (!request.azimuth && !request.elevation) return;
  if (request.view != ViewKind::kTime) {
    throw std::invalid_argument("view " + ToString(request.view) +
                                " is seen from above: expected azimuth and elevation for time");
  }
  const double elevation = request.elevation.value_or(0.0);
  if (!(0.0 <= elevation && elevation <= 90.0)) {
    throw std::invalid_argument("elevation " + std::to_string(elevation) +
                                " degrees: expected 0 to 90");
  }
}

}  // namespace

int OversamplingOf(const ViewRequest& request) {
  constexpr double kMaxPixels = 3840.0 * 2160.0;
  return 1.0 * request.width * request.height > kMaxPixels ? 1 : 2;
}

Scene BuildScene(const Recording& recording, const ViewRequest& request, int oversampling) {
  GridCache cache(recording);
  return BuildScene(&cache, request, oversampling);
}

Scene BuildScene(GridCache* cache, const ViewRequest& request, int oversampling) {
  RequireLayers(request);
  RequireCamera(request);
  RequireSide(request);
  const Recording& recording = cache->recording();
  switch (request.view) {
    case ViewKind::kMap:
      return BuildMapView(cache, request, oversampling);
    case ViewKind::kSubmap:
      return BuildSubmapView(recording, request, oversampling);
    case ViewKind::kUpdate:
      return BuildUpdateView(recording, request, oversampling);
    case ViewKind::kMatch:
      return BuildMatchView(recording, request, oversampling);
    case ViewKind::kSearch:
      return BuildSearchView(recording, request, oversampling);
    case ViewKind::kTime:
      return BuildTimeView(cache, request, oversampling);
    case ViewKind::kChart:
      return BuildChartView(recording, request, oversampling);
    case ViewKind::kGraph:
      break;
  }
  return BuildGraphView(cache, request, oversampling);
}

}  // namespace loopscope
