// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/odometry_calibration.h"

#include <cmath>

namespace loopscope {
namespace {

/// [m^2] Weight of the guess that odometry is right: as much as a metre of way.
constexpr double kPriorSquaredWay = 1.0;

/// Where matching and odometry differ by more, one of them failed.
constexpr double kMaxDistance = 0.3;                 // [m]
constexpr double kMaxTurn = DegreesToRadians(10.0);  // [rad]

}  // namespace

Eigen::Vector2d OdometryCalibration::MotionPerMeter() const {
  return Eigen::Vector2d::UnitX() + way_times_error_ / (kPriorSquaredWay + squared_way_);
}

Pose2 OdometryCalibration::Corrected(const Pose2& odometry_motion) const {
  const Eigen::Vector2d ahead = MotionPerMeter();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const Eigen::Vector2d& measured = odometry_motion.translation;
  return {measured.x() * ahead + measured.y() * left, odometry_motion.rotation};
}

void OdometryCalibration::Learn(const Pose2& odometry_motion, const Pose2& matched_motion) {
  if (memory_ == 0.0) return;
  const Eigen::Vector2d error = matched_motion.translation - odometry_motion.translation;
  const double turn = NormalizeAngle(matched_motion.rotation - odometry_motion.rotation);
  if (error.norm() > kMaxDistance || std::abs(turn) > kMaxTurn) return;
  const double ahead = odometry_motion.translation.x();
  const double kept = std::exp(-std::abs(ahead) / memory_);
  squared_way_ = kept * squared_way_ + ahead * ahead;
  way_times_error_ = kept * way_times_error_ + ahead * error;
}

}  // namespace loopscope
