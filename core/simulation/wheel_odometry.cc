// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/wheel_odometry.h"

#include <cmath>

namespace loopscope {

void WheelOdometry::Move(const Pose2& old_from_new, Random* random) {
  const double distance = old_from_new.translation.norm();
  const double turn = old_from_new.rotation;
  const double distance_error = random->Gaussian(options_.distance_noise * std::sqrt(distance));
  const double turn_error =
      random->Gaussian(options_.turn_noise * std::sqrt(distance)) +
      random->Gaussian(options_.turn_noise_of_turn * std::sqrt(std::abs(turn)));
  const double scale = distance > 0.0 ? options_.distance_scale + distance_error / distance : 0.0;
  const Pose2 measured(
      scale * old_from_new.translation,
      options_.turn_scale * turn + options_.turn_per_meter * distance + turn_error);
  odom_from_base_ = odom_from_base_ * measured;
}

}  // namespace loopscope
