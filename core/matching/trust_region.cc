// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/trust_region.h"

#include <algorithm>

#include <Eigen/Eigenvalues>

namespace loopscope {
namespace {

/// Steps that promise to lower the cost by no more than this share of it are not tried.
constexpr double kMinRelativeDecrease = 1e-6;

/// Of the decrease that was predicted; those of Nocedal and Wright.
constexpr double kPoorShare = 0.25;
constexpr double kGoodShare = 0.75;

/// The model by parameters that are `scale` times as large.
QuadraticModel Scaled(const QuadraticModel& model, const Eigen::Vector3d& scale) {
  const Eigen::Vector3d inverse = scale.cwiseInverse();
  return {model.cost, inverse.cwiseProduct(model.gradient),
          inverse.asDiagonal() * model.hessian * inverse.asDiagonal()};
}

/// Newton's, but downhill also where the cost curves down: curvatures count by their sizes.
/// Dauphin et al., "Identifying and attacking the saddle point problem in high-dimensional
/// non-convex optimization", 2014.
Eigen::Vector3d DownhillStep(const QuadraticModel& model, double radius) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(model.hessian);
  const Eigen::Vector3d curvatures = principal.eigenvalues().cwiseAbs();
  const double least = std::max(1e-9 * curvatures.maxCoeff(), 1e-12);
  const Eigen::Vector3d slopes = principal.eigenvectors().transpose() * model.gradient;
  const Eigen::Vector3d step =
      principal.eigenvectors() * -slopes.cwiseQuotient(curvatures.cwiseMax(least));
  const double length = step.norm();
  return length > radius ? Eigen::Vector3d(radius / length * step) : step;
}

double PredictedDecrease(const QuadraticModel& model, const Eigen::Vector3d& step) {
  return -step.dot(model.gradient + 0.5 * model.hessian * step);
}

}  // namespace

TrustRegionMinimum MinimizeInTrustRegion(
    const std::function<QuadraticModel(const Eigen::Vector3d&)>& model_at,
    const Eigen::Vector3d& start, const TrustRegionOptions& options) {
  QuadraticModel model = Scaled(model_at(start), options.scale);
  TrustRegionMinimum minimum{start, model.cost, model.cost, 0};
  double radius = options.first_radius;
  while (minimum.num_iterations < options.max_num_iterations) {
    const Eigen::Vector3d step = DownhillStep(model, radius);
    const double predicted = PredictedDecrease(model, step);
    if (predicted <= kMinRelativeDecrease * model.cost) break;
    ++minimum.num_iterations;
    const Eigen::Vector3d next_point = minimum.point + step.cwiseQuotient(options.scale);
    const QuadraticModel next = Scaled(model_at(next_point), options.scale);
    const double share = (model.cost - next.cost) / predicted;
    const bool is_at_border = step.norm() > 0.99 * radius;
    if (share < kPoorShare) radius = 0.25 * step.norm();
    if (share > kGoodShare && is_at_border) radius *= 2.0;
    if (share <= 0.0) continue;
    minimum.point = next_point;
    minimum.final_cost = next.cost;
    model = next;
  }
  return minimum;
}

}  // namespace loopscope
