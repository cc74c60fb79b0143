// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include <Eigen/Core>

#include "core/matching/bicubic_grid.h"
#include "core/matching/ceres_scan_matcher.h"

namespace loopscope {

/// The residuals of (CS), in the form that ceres::TinySolver takes. Parameters are (x, y, theta) of
/// submap_from_scan; residuals are, in this order,
///   w_o / sqrt(K) (1 - M_smooth(T_xi h_k))  for k = 1 ... K,
///   w_t (x - x_target), w_t (y - y_target), w_r (theta - theta_target).
class ScanMatchCost {
 public:
  using Scalar = double;
  enum { NUM_RESIDUALS = Eigen::Dynamic, NUM_PARAMETERS = 3 };

  /// Keeps references to `points_in_scan` and `grid`.
  ScanMatchCost(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                const Eigen::Vector2d& target_translation, double target_rotation,
                const CeresScanMatcherOptions& options);

  int NumResiduals() const { return static_cast<int>(points_.size()) + 3; }

  /// `residuals` has NumResiduals() entries; `jacobian`, if not null, as many rows of 3,
  /// column-major.
  bool operator()(const double* pose, double* residuals, double* jacobian) const;

 private:
  struct Evaluation {
    Eigen::Vector3d pose;
    PointCloud arms;  ///< R h_k [m]
    SmoothValues smooth;
  };

  const Evaluation& EvaluationAt(const Eigen::Vector3d& pose) const;

  const PointCloud& points_;
  BicubicGrid smooth_;
  Eigen::Vector3d target_;
  Eigen::Vector3d prior_weights_;
  double point_weight_;
  /// The solver asks for the jacobian where it asked for the residuals before.
  mutable std::optional<Evaluation> last_;
};

}  // namespace loopscope
