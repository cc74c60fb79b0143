// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/match_score.h"

#include <cassert>

namespace loopscope {

double MeanProbability(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                       const ProbabilityGrid& grid) {
  assert(!points_in_scan.empty());
  double sum = 0.0;
  for (const Eigen::Vector2d& point : Transform(submap_from_scan, points_in_scan)) {
    sum += grid.probability(CellOf(point, grid.resolution()));
  }
  return sum / static_cast<double>(points_in_scan.size());
}

}  // namespace loopscope
