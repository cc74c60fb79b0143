// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include <Eigen/Core>

namespace loopscope {

/// A cost of three parameters near a point, to the second order.
struct QuadraticModel {
  double cost = 0.0;
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
  Eigen::Matrix3d hessian = Eigen::Matrix3d::Zero();  ///< symmetric
};

struct TrustRegionOptions {
  /// Parameters times these are comparable; lengths of steps are of such products.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  double first_radius = 1.0;  ///< no first step is longer
  int max_num_iterations = 20;
};

struct TrustRegionMinimum {
  Eigen::Vector3d point;
  double initial_cost = 0.0;
  double final_cost = 0.0;
  int num_iterations = 0;  ///< steps that were tried
};

/// A minimum near `start` of a cost that is nowhere negative, by Newton steps no longer than a
/// radius that grows and shrinks as the cost does what its model says. Nocedal and Wright,
/// "Numerical Optimization", algorithm 4.1.
TrustRegionMinimum MinimizeInTrustRegion(
    const std::function<QuadraticModel(const Eigen::Vector3d&)>& model_at,
    const Eigen::Vector3d& start, const TrustRegionOptions& options);

}  // namespace loopscope
