// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/spa_cost.h"

#include <cmath>

namespace loopscope {
namespace {

double RotationError(const Pose2& i_from_j, const Pose2& global_from_i,
                     const Pose2& global_from_j) {
  return NormalizeAngle(i_from_j.rotation - (global_from_j.rotation - global_from_i.rotation));
}

}  // namespace

Eigen::Vector3d SpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                         const Pose2& global_from_j) {
  const Eigen::Vector2d translation =
      i_from_j.translation - global_from_i.RotationMatrix().transpose() *
                                 (global_from_j.translation - global_from_i.translation);
  return {translation.x(), translation.y(), RotationError(i_from_j, global_from_i, global_from_j)};
}

Eigen::Vector3d GlobalSpaError(const Pose2& i_from_j, const Pose2& global_from_i,
                               const Eigen::Matrix2d& global_from_i_rotation,
                               const Pose2& global_from_j) {
  const Eigen::Vector2d translation = global_from_i_rotation * i_from_j.translation -
                                      (global_from_j.translation - global_from_i.translation);
  return {translation.x(), translation.y(), RotationError(i_from_j, global_from_i, global_from_j)};
}

SpaQuadratic::SpaQuadratic(const Eigen::Vector3d& global_error, const Pose2& global_from_i,
                           const Pose2& global_from_j, const SpaInformation& information) {
  const double t = information.translation;
  const double r = information.rotation;
  // Turned by R_i, the derivatives by i are (I, s; 0, 1), those by j are -I, where s, the arm
  // turned by a right angle, is how the end of the arm seems to move back when i turns.
  const Eigen::Vector2d arm = global_from_j.translation - global_from_i.translation;
  const Eigen::Vector2d s(-arm.y(), arm.x());
  const Eigen::Vector2d error = t * global_error.head<2>();
  const double turn = r * global_error.z();
  ii << t, 0.0, t * s.x(),  //
      0.0, t, t * s.y(),    //
      t * s.x(), t * s.y(), t * s.squaredNorm() + r;
  ji << -t, 0.0, -t * s.x(),  //
      0.0, -t, -t * s.y(),    //
      0.0, 0.0, -r;
  jj << t, 0.0, 0.0,  //
      0.0, t, 0.0,    //
      0.0, 0.0, r;
  by_i << error, s.dot(error) + turn;
  by_j << -error, -turn;
}

double HuberWeight(double square, double scale) {
  return square > scale * scale ? scale / std::sqrt(square) : 1.0;
}

double HuberCost(double square, double scale) {
  return 0.5 * (square > scale * scale ? scale * (2.0 * std::sqrt(square) - scale) : square);
}

}  // namespace loopscope
