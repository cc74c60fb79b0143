// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/geometry/trajectory.h"
#include "core/sensor/scan_log.h"
#include "core/simulation/drive.h"
#include "core/simulation/lidar.h"
#include "core/simulation/wheel_odometry.h"
#include "core/simulation/world.h"

namespace loopscope {

struct SimulationOptions {
  std::uint64_t seed = 1;              ///< of all noise
  double start_time = 1.0e9;           ///< [s] stamp of the first scan
  double scan_period = 0.2;            ///< [s]
  int odometry_readings_per_scan = 4;  ///< the last of them has the stamp of the scan
  double laser_offset = 0.1;           ///< [m] of the scanner in front of the middle of the robot
  DriveOptions drive;
  LidarOptions lidar;
  WheelOdometryOptions wheel_odometry;
};

struct Simulation {
  ScanLog log;              ///< named after the world
  Trajectory ground_truth;  ///< world_from_base, exact, at every stamp of the log
};

/// Drives a robot along the route of `world` and logs what its sensors read. The same world,
/// options and seed give the same log. Throws std::invalid_argument that names the option that is
/// out of its range.
Simulation Simulate(const World& world, const SimulationOptions& options);

}  // namespace loopscope
