// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/odometry_direction.h"

#include <cmath>

#include <Eigen/Geometry>

namespace loopscope {
namespace {

/// [m^2] Weight of the guess that the scanner looks straight ahead: as much as a metre of way.
constexpr double kPriorSquaredWay = 1.0;

/// Where matching and odometry differ by more, one of them failed.
constexpr double kMaxDistance = 0.3;                 // [m]
constexpr double kMaxTurn = DegreesToRadians(10.0);  // [rad]

}  // namespace

double OdometryDirection::angle() const { return drift_left_ / (kPriorSquaredWay + squared_way_); }

Pose2 OdometryDirection::Corrected(const Pose2& odometry_motion) const {
  return {Eigen::Rotation2Dd(angle()) * odometry_motion.translation, odometry_motion.rotation};
}

void OdometryDirection::Learn(const Pose2& odometry_motion, const Pose2& matched_motion) {
  if (memory_ == 0.0) return;
  const Eigen::Vector2d error = matched_motion.translation - odometry_motion.translation;
  const double turn = NormalizeAngle(matched_motion.rotation - odometry_motion.rotation);
  if (error.norm() > kMaxDistance || std::abs(turn) > kMaxTurn) return;
  const double ahead = odometry_motion.translation.x();
  const double kept = std::exp(-std::abs(ahead) / memory_);
  squared_way_ = kept * squared_way_ + ahead * ahead;
  drift_left_ = kept * drift_left_ + ahead * error.y();
}

}  // namespace loopscope
