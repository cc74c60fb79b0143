// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// *.ceres_scan_matcher. The paper leaves (CS) to Ceres, so that is what Cartographer calls them.
struct CeresScanMatcherOptions {
  double occupied_space_weight = 1.0;
  double translation_weight = 10.0;  ///< on leaving the target, a metre
  double rotation_weight = 40.0;     ///< on turning from the start, a radian
  int max_num_iterations = 20;
};

struct RefinedMatch {
  Pose2 submap_from_scan;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  int num_iterations = 0;
};

/// (CS) of the paper: the pose near `submap_from_scan_start` that minimizes
///   w_o^2 / K sum_k (1 - M_smooth(T_xi h_k))^2 + w_t^2 |t - t_target|^2 + w_r^2 (theta -
///   theta_start)^2
/// with M_smooth bicubic in the grid. `target` is where the translation prior pulls to.
///
/// By Newton's method with all second derivatives. That of Gauss and Newton, which is Ceres', knows
/// only the slopes of M_smooth; on a wall these are zero, and it gropes for the minimum.
RefinedMatch RefineScanMatch(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                             const Eigen::Vector2d& target_translation,
                             const Pose2& submap_from_scan_start,
                             const CeresScanMatcherOptions& options);

/// The pose that this finds if the start is the target, too.
Pose2 RefinedPose(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                  const Pose2& submap_from_scan_start, const CeresScanMatcherOptions& options);

}  // namespace loopscope
