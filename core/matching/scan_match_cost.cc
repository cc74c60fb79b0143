// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/scan_match_cost.h"

#include <cmath>

namespace loopscope {

ScanMatchCost::ScanMatchCost(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                             const Eigen::Vector2d& target_translation, double target_rotation,
                             const CeresScanMatcherOptions& options)
    : points_(points_in_scan),
      smooth_(grid),
      target_(target_translation.x(), target_translation.y(), target_rotation),
      prior_weights_(options.translation_weight, options.translation_weight,
                     options.rotation_weight),
      point_weight_(options.occupied_space_weight /
                    std::sqrt(static_cast<double>(points_in_scan.size()))) {}

QuadraticModel ScanMatchCost::At(const Eigen::Vector3d& pose) const {
  const Eigen::Matrix2d rotation = Pose2(0.0, 0.0, pose.z()).RotationMatrix();
  PointCloud places(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    places[k] = rotation * points_[k] + pose.head<2>();
  }
  const SmoothValues smooth = smooth_.At(places);

  QuadraticModel model;
  for (std::size_t k = 0; k < points_.size(); ++k) {
    const double lack = 1.0 - smooth.values[k];
    const double slope_x = smooth.slopes_x[k];
    const double slope_y = smooth.slopes_y[k];
    const double xx = smooth.curvatures_xx[k];
    const double xy = smooth.curvatures_xy[k];
    const double yy = smooth.curvatures_yy[k];
    // R h, whose derivative by theta is itself turned by a quarter.
    const Eigen::Vector2d arm = places[k] - pose.head<2>();
    const double by_angle = arm.x() * slope_y - arm.y() * slope_x;
    const double by_angle_x = arm.x() * xy - arm.y() * xx;
    const double by_angle_y = arm.x() * yy - arm.y() * xy;
    const double by_angle_twice =
        arm.x() * by_angle_y - arm.y() * by_angle_x - (arm.x() * slope_x + arm.y() * slope_y);
    model.cost += lack * lack;
    model.gradient.x() -= lack * slope_x;
    model.gradient.y() -= lack * slope_y;
    model.gradient.z() -= lack * by_angle;
    model.hessian(0, 0) += slope_x * slope_x - lack * xx;
    model.hessian(1, 0) += slope_x * slope_y - lack * xy;
    model.hessian(1, 1) += slope_y * slope_y - lack * yy;
    model.hessian(2, 0) += by_angle * slope_x - lack * by_angle_x;
    model.hessian(2, 1) += by_angle * slope_y - lack * by_angle_y;
    model.hessian(2, 2) += by_angle * by_angle - lack * by_angle_twice;
  }
  const double weight = point_weight_ * point_weight_;
  model.cost *= 0.5 * weight;
  model.gradient *= weight;
  model.hessian *= weight;

  const Eigen::Vector3d weighted = prior_weights_.cwiseProduct(pose - target_);
  model.cost += 0.5 * weighted.squaredNorm();
  model.gradient += prior_weights_.cwiseProduct(weighted);
  model.hessian.diagonal() += prior_weights_.cwiseAbs2();
  model.hessian = Eigen::Matrix3d(model.hessian.selfadjointView<Eigen::Lower>());
  return model;
}

}  // namespace loopscope
