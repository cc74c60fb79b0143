// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/inspection.h"

#include "render/inspections/inspections.h"

namespace loopscope {
namespace {

Look LookOf(DerivedCache* cache, const ViewRequest& request, const Scene& scene) {
  const Recording& recording = cache->recording();
  switch (request.view) {
    case ViewKind::kSubmap:
      return InspectSubmap(recording, request);
    case ViewKind::kUpdate:
      return InspectUpdate(recording, request);
    case ViewKind::kMatch:
      return InspectMatch(recording, request);
    case ViewKind::kSearch: {
      const Box& chart = scene.panels.back().frame;
      return InspectSearch(cache, request, chart.width / chart.height);
    }
    case ViewKind::kChart:
      return InspectChart(recording, request, scene);
    case ViewKind::kTime:
      return [](int, const Eigen::Vector2d&, double) { return std::nullopt; };
    case ViewKind::kMap:
    case ViewKind::kGraph:
      break;
  }
  return InspectGraph(recording, request);
}

}  // namespace

Inspector::Inspector(DerivedCache* cache, const ViewRequest& request, const Scene& scene)
    : look_(LookOf(cache, request, scene)) {}

}  // namespace loopscope
