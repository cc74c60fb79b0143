// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/spa_cost.h"

#include <ceres/sized_cost_function.h>

namespace loopscope {
namespace {

class SpaCost : public ceres::SizedCostFunction<3, 3, 3> {
 public:
  SpaCost(const Pose2& i_from_j, double translation_weight, double rotation_weight)
      : i_from_j_(i_from_j),
        translation_weight_(translation_weight),
        rotation_weight_(rotation_weight) {}

  bool Evaluate(const double* const* parameters, double* residuals,
                double** jacobians) const override {
    const Pose2 global_from_i(parameters[0][0], parameters[0][1], parameters[0][2]);
    const Pose2 global_from_j(parameters[1][0], parameters[1][1], parameters[1][2]);
    const Eigen::Vector3d weights(translation_weight_, translation_weight_, rotation_weight_);
    Eigen::Map<Eigen::Vector3d> error(residuals);
    error = weights.cwiseProduct(SpaError(i_from_j_, global_from_i, global_from_j));
    if (jacobians == nullptr) return true;

    using Jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Matrix2d i_from_global = global_from_i.RotationMatrix().transpose();
    const Eigen::Vector2d arm =
        i_from_global * (global_from_j.translation - global_from_i.translation);
    if (jacobians[0] != nullptr) {
      Eigen::Map<Jacobian> by_i(jacobians[0]);
      by_i.setZero();
      by_i.topLeftCorner<2, 2>() = translation_weight_ * i_from_global;
      // R_i^-1 d turns backwards with theta_i.
      by_i(0, 2) = -translation_weight_ * arm.y();
      by_i(1, 2) = translation_weight_ * arm.x();
      by_i(2, 2) = rotation_weight_;
    }
    if (jacobians[1] != nullptr) {
      Eigen::Map<Jacobian> by_j(jacobians[1]);
      by_j.setZero();
      by_j.topLeftCorner<2, 2>() = -translation_weight_ * i_from_global;
      by_j(2, 2) = -rotation_weight_;
    }
    return true;
  }

 private:
  Pose2 i_from_j_;
  double translation_weight_;
  double rotation_weight_;
};

}  // namespace

std::unique_ptr<ceres::CostFunction> MakeSpaCost(const Pose2& i_from_j, double translation_weight,
                                                 double rotation_weight) {
  return std::make_unique<SpaCost>(i_from_j, translation_weight, rotation_weight);
}

Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j) {
  const Eigen::Vector2d translation =
      i_from_j.translation - global_from_i.RotationMatrix().transpose() *
                                 (global_from_j.translation - global_from_i.translation);
  const double rotation =
      NormalizeAngle(i_from_j.rotation - (global_from_j.rotation - global_from_i.rotation));
  return {translation.x(), translation.y(), rotation};
}

}  // namespace loopscope
