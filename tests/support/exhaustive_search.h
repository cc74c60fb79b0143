// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "core/grid/probability_grid.h"
#include "core/matching/branch_and_bound.h"
#include "core/matching/search_trace.h"

namespace loopscope {

/// The mean of M_nearest at the points, each rounded to the 256 steps of a precomputed grid.
inline double PlainScore(const PointCloud& points_in_scan, const Pose2& submap_from_scan,
                         const ProbabilityGrid& grid) {
  double sum = 0.0;
  for (const Eigen::Vector2d& point : points_in_scan) {
    const CellIndex cell = CellOf(submap_from_scan * point, grid.resolution());
    sum += std::round((grid.probability(cell) - 0.1) / 0.8 * 255.0);
  }
  return 0.1 + 0.8 * sum / 255.0 / static_cast<double>(points_in_scan.size());
}

/// The pose of eq. 10.
inline Pose2 PlainPose(const SearchWindow& window, CellIndex offset, int angle_index) {
  const Pose2& guess = window.submap_from_scan_guess;
  return Pose2(guess.x() + window.resolution * offset.x, guess.y() + window.resolution * offset.y,
               guess.rotation + window.angular_step * angle_index);
}

/// Calls `visit(offset, angle_index)` for every pose of the window, eq. 9.
template <typename Visitor>
void ForEachPose(const SearchWindow& window, const Visitor& visit) {
  const int w = window.num_linear_steps;
  for (int x = -w; x <= w; ++x) {
    for (int y = -w; y <= w; ++y) {
      for (int angle = -window.num_angular_steps; angle <= window.num_angular_steps; ++angle) {
        visit(CellIndex{x, y}, angle);
      }
    }
  }
}

/// Algorithm 1: tries all poses of the window.
inline SearchResult ExhaustiveSearch(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                     const SearchWindow& window) {
  SearchResult best;
  ForEachPose(window, [&](CellIndex offset, int angle_index) {
    const Pose2 pose = PlainPose(window, offset, angle_index);
    const double score = PlainScore(points_in_scan, pose, grid);
    if (score > best.score) best = {pose, score};
  });
  return best;
}

}  // namespace loopscope
