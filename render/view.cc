// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <cmath>
#include <stdexcept>
#include <tuple>

#include <fmt/format.h>

#include "render/views/views.h"

namespace loopscope {
namespace {

void RequireLayer(ViewKind view, LayerKind kind) {
  const std::set<LayerKind>& all = LayersOf(view);
  if (all.count(kind) > 0) return;
  std::string expected;
  for (const LayerKind known : all) expected += (expected.empty() ? "" : ", ") + ToString(known);
  throw std::invalid_argument("view " + ToString(view) + " has no layer '" + ToString(kind) +
                              "': expected some of " + expected);
}

void RequireLayers(const ViewRequest& request) {
  if (request.layers) {
    for (const LayerKind kind : *request.layers) RequireLayer(request.view, kind);
  }
  for (const auto& [kind, opacity] : request.opacities) {
    RequireLayer(request.view, kind);
    if (opacity >= 0.0 && opacity <= 1.0) continue;
    throw std::invalid_argument(
        fmt::format("opacity of layer '{}' is {:g}: expected 0 to 1", ToString(kind), opacity));
  }
}

void RequireTextHeight(const ViewRequest& request) {
  constexpr int kMin = 8, kMax = 200;
  if (!request.text_height) return;
  if (*request.text_height >= kMin && *request.text_height <= kMax) return;
  throw std::invalid_argument(
      fmt::format("text is {} px high: expected {} to {}", *request.text_height, kMin, kMax));
}

void RequireFilter(const ViewRequest& request) {
  if (request.search.empty() || request.view == ViewKind::kSearch) return;
  throw std::invalid_argument("view " + ToString(request.view) +
                              " has no visits, heights or angles: expected view search");
}

void RequireCamera(const ViewRequest& request) {
  const auto& width = request.width_in_meters;
  const auto& height = request.height_in_meters;
  if (request.view == ViewKind::kChart && (request.center || width || height)) {
    throw std::invalid_argument("view chart has no map: expected no center and no size of it");
  }
  for (const auto& [name, size] : {std::pair("width", width), std::pair("height", height)}) {
    if (!size || (*size > 0.0 && *size <= kMaxMapCoordinate)) continue;
    throw std::invalid_argument(
        fmt::format("{} of the map is {:g} m: expected more than 0, and at most {:g}", name, *size,
                    kMaxMapCoordinate));
  }
  if (request.center && !(request.center->cwiseAbs().maxCoeff() <= kMaxMapCoordinate)) {
    throw std::invalid_argument(
        fmt::format("center of the map is {:g}, {:g}: expected two numbers of at most {:g} m",
                    request.center->x(), request.center->y(), kMaxMapCoordinate));
  }
}

void RequireSide(const ViewRequest& request) {
  if (!request.azimuth && !request.elevation) return;
  if (request.view != ViewKind::kTime) {
    throw std::invalid_argument("view " + ToString(request.view) +
                                " is seen from above: expected azimuth and elevation for time");
  }
  if (!std::isfinite(request.azimuth.value_or(0.0))) {
    throw std::invalid_argument("azimuth: expected a finite number of degrees");
  }
  const double elevation = request.elevation.value_or(0.0);
  if (!(0.0 <= elevation && elevation <= 90.0)) {
    throw std::invalid_argument("elevation " + std::to_string(elevation) +
                                " degrees: expected 0 to 90");
  }
}

void RequireMarks(const ViewRequest& request) {
  const std::set<ViewKind> of_graph{ViewKind::kMap, ViewKind::kGraph, ViewKind::kTime,
                                    ViewKind::kChart};
  if (request.marked.empty() || of_graph.count(request.view) > 0) return;
  throw std::invalid_argument("view " + ToString(request.view) +
                              " marks no loops: expected view map, graph, time or chart");
}

}  // namespace

bool operator==(const LoopPair& a, const LoopPair& b) {
  return a.node == b.node && a.submap == b.submap;
}

bool operator==(const ViewRequest& a, const ViewRequest& b) {
  const auto fields = [](const ViewRequest& r) {
    return std::tie(r.view, r.step, r.node, r.submap, r.marked, r.width, r.height, r.theme, r.title,
                    r.layers, r.opacities, r.center, r.width_in_meters, r.height_in_meters,
                    r.azimuth, r.elevation, r.chart, r.plain, r.text_height, r.search.num_visits,
                    r.search.height, r.search.angle_index);
  };
  return fields(a) == fields(b);
}

int OversamplingOf(const ViewRequest& request) {
  constexpr double kMaxPixels = 3840.0 * 2160.0;
  return 1.0 * request.width * request.height > kMaxPixels ? 1 : 2;
}

Scene BuildScene(const Recording& recording, const ViewRequest& request, int oversampling) {
  DerivedCache cache(recording);
  return BuildScene(&cache, request, oversampling);
}

Scene BuildScene(DerivedCache* cache, const ViewRequest& request, int oversampling) {
  RequireLayers(request);
  RequireFilter(request);
  RequireMarks(request);
  RequireCamera(request);
  RequireSide(request);
  RequireTextHeight(request);
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
      return BuildSearchView(cache, request, oversampling);
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
