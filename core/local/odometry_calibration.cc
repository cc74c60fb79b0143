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
  const auto error = [](const Sums& sums) {
    return sums.way_times_error / (kPriorSquaredWay + sums.squared_way);
  };
  return {1.0 + error(ahead_), error(left_)};
}

Pose2 OdometryCalibration::Corrected(const Pose2& odometry_motion) const {
  const Eigen::Vector2d ahead = MotionPerMeter();
  const Eigen::Vector2d left(-ahead.y(), ahead.x());
  const Eigen::Vector2d& measured = odometry_motion.translation;
  return {measured.x() * ahead + measured.y() * left, odometry_motion.rotation};
}

void OdometryCalibration::Learn(const Pose2& odometry_motion, const Pose2& matched_motion,
                                bool way_is_held) {
  if (memory_ == 0.0) return;
  const Eigen::Vector2d error = matched_motion.translation - odometry_motion.translation;
  const double turn = NormalizeAngle(matched_motion.rotation - odometry_motion.rotation);
  if (error.norm() > kMaxDistance || std::abs(turn) > kMaxTurn) return;
  const double way = odometry_motion.translation.x();
  const double kept = std::exp(-std::abs(way) / memory_);
  Add(way, error.y(), kept, &left_);
  if (way_is_held) Add(way, error.x(), kept, &ahead_);
}

void OdometryCalibration::Add(double way, double error, double kept, Sums* sums) {
  sums->squared_way = kept * sums->squared_way + way * way;
  sums->way_times_error = kept * sums->way_times_error + way * error;
}

}  // namespace loopscope
