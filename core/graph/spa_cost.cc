// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/spa_cost.h"

#include <cmath>

namespace loopscope {

Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j) {
  return SpaError(i_from_j, global_from_i, global_from_i.RotationMatrix().transpose(),
                  global_from_j);
}

Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Eigen::Matrix2d& i_from_global, const Pose2& global_from_j) {
  const Eigen::Vector2d translation =
      i_from_j.translation -
      i_from_global * (global_from_j.translation - global_from_i.translation);
  const double rotation =
      NormalizeAngle(i_from_j.rotation - (global_from_j.rotation - global_from_i.rotation));
  return {translation.x(), translation.y(), rotation};
}

SpaDerivatives DerivativesOfSpaError(const Pose2& global_from_i,
                                     const Eigen::Matrix2d& i_from_global,
                                     const Pose2& global_from_j) {
  const Eigen::Vector2d arm =
      i_from_global * (global_from_j.translation - global_from_i.translation);
  SpaDerivatives derivatives;
  derivatives.by_i.setIdentity();
  derivatives.by_i.topLeftCorner<2, 2>() = i_from_global;
  // R_i^-1 d turns backwards with theta_i.
  derivatives.by_i(0, 2) = -arm.y();
  derivatives.by_i(1, 2) = arm.x();
  derivatives.by_j.setZero();
  derivatives.by_j.topLeftCorner<2, 2>() = -i_from_global;
  derivatives.by_j(2, 2) = -1.0;
  return derivatives;
}

double HuberWeight(double square, double scale) {
  return square > scale * scale ? scale / std::sqrt(square) : 1.0;
}

}  // namespace loopscope
