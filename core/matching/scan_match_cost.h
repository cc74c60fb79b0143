// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/matching/bicubic_grid.h"
#include "core/matching/scan_match_refinement.h"
#include "core/matching/trust_region.h"

namespace loopscope {

/// The cost of (CS), half the sum of the squares of
///   w_o / sqrt(K) (1 - M_smooth(T_xi h_k))  for k = 1 ... K,
///   w_t (x - x_target), w_t (y - y_target), w_r (theta - theta_target),
/// at xi = (x, y, theta) of submap_from_scan.
class ScanMatchCost {
 public:
  /// Keeps references to `points_in_scan` and `grid`.
  ScanMatchCost(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                const Eigen::Vector2d& target_translation, double target_rotation,
                const CeresScanMatcherOptions& options);

  /// With its derivatives by x, y and theta.
  QuadraticModel At(const Eigen::Vector3d& pose) const;

 private:
  const PointCloud& points_;
  BicubicGrid smooth_;
  Eigen::Vector3d target_;
  Eigen::Vector3d prior_weights_;
  double point_weight_;
};

}  // namespace loopscope
