// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.
struct CorrelativeScanMatcherOptions {
  double linear_search_window = 0.1;                     ///< [m]
  double angular_search_window = DegreesToRadians(20.);  ///< [rad]
  double translation_delta_cost_weight = 1e-1;           ///< a metre
  double rotation_delta_cost_weight = 1e-1;              ///< a radian
};

struct CorrelativeMatch {
  Pose2 submap_from_scan;
  double score = 0.0;  ///< mean probability at the points, in [0.1, 0.9], times the delta penalty
};

/// The best pose on the lattice of the window (eqs. 7 to 10) around the guess; each pose is scored
/// by mean_k M_nearest(T_xi h_k) * exp(-(w_t |dt| + w_r |dtheta|)^2), after Olson, "Real-Time
/// Correlative Scan Matching", ICRA 2009.
CorrelativeMatch MatchCorrelative(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                  const Pose2& submap_from_scan_guess,
                                  const CorrelativeScanMatcherOptions& options);

}  // namespace loopscope
