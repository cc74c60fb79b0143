// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/uncertainty.h"

#include <algorithm>

#include "core/slam/covariance.h"
#include "render/scale_bar.h"

namespace loopscope {

std::vector<UncertainPoint> UncertaintyOfSubmaps(const Recording& recording, const MapState& state,
                                                 int max_count) {
  std::vector<UncertainPoint> points;
  const int count = std::min(max_count, state.num_submaps - 1);
  for (int i = 1; i <= count; ++i) {
    const SubmapId submap{i * (state.num_submaps - 1) / count};
    const auto covariance = CovarianceOfSubmap(recording, state, submap);
    if (!covariance) continue;
    points.push_back(
        {state.global_from_submap[submap.index].translation, covariance->topLeftCorner<2, 2>()});
  }
  return points;
}

double EllipseFactor(const std::vector<UncertainPoint>& points, double max_radius) {
  double largest = 0.0;
  for (const UncertainPoint& point : points) {
    largest = std::max(largest, point.LargestDeviation());
  }
  return largest > 0.0 ? RoundLength(max_radius / largest) : 1.0;
}

}  // namespace loopscope
