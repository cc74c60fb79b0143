// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/scan_match_cost.h"

#include <cmath>
#include <utility>

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

bool ScanMatchCost::operator()(const double* pose, double* residuals, double* jacobian) const {
  const int num_points = static_cast<int>(points_.size());
  const int num_rows = NumResiduals();
  const Evaluation& evaluation = EvaluationAt(Eigen::Vector3d(pose));
  const PointCloud& arms = evaluation.arms;
  const SmoothValues& smooth = evaluation.smooth;
  for (int k = 0; k < num_points; ++k) {
    residuals[k] = point_weight_ * (1.0 - smooth.values[k]);
    if (jacobian == nullptr) continue;
    // d (R h) / d theta is R h turned by a quarter.
    const double by_angle = -arms[k].y() * smooth.slopes_x[k] + arms[k].x() * smooth.slopes_y[k];
    jacobian[k] = -point_weight_ * smooth.slopes_x[k];
    jacobian[k + num_rows] = -point_weight_ * smooth.slopes_y[k];
    jacobian[k + 2 * num_rows] = -point_weight_ * by_angle;
  }
  for (int i = 0; i < 3; ++i) {
    residuals[num_points + i] = prior_weights_[i] * (pose[i] - target_[i]);
    if (jacobian == nullptr) continue;
    for (int j = 0; j < 3; ++j) {
      jacobian[num_points + i + j * num_rows] = i == j ? prior_weights_[i] : 0.0;
    }
  }
  return true;
}

const ScanMatchCost::Evaluation& ScanMatchCost::EvaluationAt(const Eigen::Vector3d& pose) const {
  if (last_ && last_->pose == pose) return *last_;
  const Eigen::Vector2d translation = pose.head<2>();
  const Eigen::Matrix2d rotation = Pose2(0.0, 0.0, pose.z()).RotationMatrix();
  PointCloud arms(points_.size());
  PointCloud places(points_.size());
  for (std::size_t k = 0; k < points_.size(); ++k) {
    arms[k] = rotation * points_[k];
    places[k] = arms[k] + translation;
  }
  last_ = Evaluation{pose, std::move(arms), smooth_.At(places)};
  return *last_;
}

}  // namespace loopscope
