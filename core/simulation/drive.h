// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/trajectory.h"

namespace loopscope {

/// How a robot with two driven wheels follows waypoints.
struct DriveOptions {
  double max_speed = 0.8;          ///< [m/s]
  double max_turn_rate = 1.0;      ///< [rad/s]
  double acceleration = 0.8;       ///< [m/s^2], also when braking
  double turn_acceleration = 3.0;  ///< [rad/s^2]
  double reach = 0.3;              ///< [m] from a waypoint at which it heads for the next one
};

/// Drives along `route` (at least two waypoints, in the frame of the world) and stops at its end.
/// Begins at rest on the first waypoint at time 0, heading for the second. The poses, one every
/// `period` [s], are those of the robot in the frame of the world.
Trajectory Drive(const std::vector<Eigen::Vector2d>& route, const DriveOptions& options,
                 double period);

}  // namespace loopscope
