// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"
#include "core/simulation/random.h"

namespace loopscope {

/// What wheels make of a motion: biases, which add up, and noise, which wanders.
struct WheelOdometryOptions {
  double distance_scale = 1.015;     ///< measured over true distance
  double turn_scale = 1.01;          ///< measured over true turn
  double turn_per_meter = 0.003;     ///< [rad/m] of unequal wheels
  double distance_noise = 0.01;      ///< [m] standard deviation after a metre; grows with its root
  double turn_noise = 0.01;          ///< [rad] likewise, after a metre
  double turn_noise_of_turn = 0.02;  ///< [rad] likewise, after a radian
};

/// Adds up what the wheels report.
class WheelOdometry {
 public:
  explicit WheelOdometry(const WheelOdometryOptions& options) : options_(options) {}

  /// Reports the motion of the robot from its old to its new pose.
  void Move(const Pose2& old_from_new, Random* random);

  /// Begins at the identity.
  const Pose2& odom_from_base() const { return odom_from_base_; }

 private:
  WheelOdometryOptions options_;
  Pose2 odom_from_base_;
};

}  // namespace loopscope
