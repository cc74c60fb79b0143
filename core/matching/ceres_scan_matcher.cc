// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/ceres_scan_matcher.h"

#include <cassert>
#include <cmath>

#include <ceres/tiny_solver.h>

#include "core/matching/scan_match_cost.h"

namespace loopscope {

CeresMatch MatchWithCeres(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                          const Eigen::Vector2d& target_translation,
                          const Pose2& submap_from_scan_start,
                          const CeresScanMatcherOptions& options) {
  assert(!points_in_scan.empty());
  const ScanMatchCost cost(points_in_scan, grid, target_translation,
                           submap_from_scan_start.rotation, options);
  ceres::TinySolver<ScanMatchCost> solver;
  solver.options.max_num_iterations = options.max_num_iterations;
  Eigen::Vector3d pose(submap_from_scan_start.x(), submap_from_scan_start.y(),
                       submap_from_scan_start.rotation);
  const auto& summary = solver.Solve(cost, &pose);
  return {Pose2(pose.x(), pose.y(), NormalizeAngle(pose.z())), summary.initial_cost,
          summary.final_cost, summary.iterations};
}

}  // namespace loopscope
