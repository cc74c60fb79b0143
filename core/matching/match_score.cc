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

bool HoldsAhead(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                const ProbabilityGrid& grid) {
  constexpr double kShift = 0.1;  // [m]
  constexpr double kMaxShare = 0.8;
  const double score = MeanProbability(points_in_scan, submap_from_scan, grid);
  for (const double shift : {-kShift, kShift}) {
    const Pose2 shifted = submap_from_scan * Pose2(shift, 0.0, 0.0);
    if (MeanProbability(points_in_scan, shifted, grid) > kMaxShare * score) return false;
  }
  return true;
}

KnownScore ScoreOfKnown(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                        const ProbabilityGrid& grid) {
  KnownScore score;
  double sum = 0.0;
  for (const Eigen::Vector2d& point : Transform(submap_from_scan, points_in_scan)) {
    const CellIndex cell = CellOf(point, grid.resolution());
    if (!grid.known(cell)) continue;
    sum += grid.probability(cell);
    ++score.num_points;
  }
  if (score.num_points > 0) score.mean_probability = sum / score.num_points;
  return score;
}

}  // namespace loopscope
