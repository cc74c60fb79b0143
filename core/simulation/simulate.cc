// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulate.h"

#include <stdexcept>

#include <fmt/format.h>

namespace loopscope {
namespace {

// Both ends of the range are allowed.
void CheckRange(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return;
  throw std::invalid_argument(fmt::format("simulation: {} = {} is out of range; expected {} to {}",
                                          name, value, low, high));
}

void Check(const SimulationOptions& options) {
  CheckRange("scan_period", options.scan_period, 0.01, 10.0);
  CheckRange("odometry_readings_per_scan", options.odometry_readings_per_scan, 1, 100);
  CheckRange("start_time", options.start_time, -1e12, 1e12);
  CheckRange("laser_offset", options.laser_offset, -10.0, 10.0);
  CheckRange("drive.max_speed", options.drive.max_speed, 0.1, 2.0);
  CheckRange("drive.max_turn_rate", options.drive.max_turn_rate, 0.1, 10.0);
  CheckRange("drive.acceleration", options.drive.acceleration, 0.01, 100.0);
  CheckRange("drive.turn_acceleration", options.drive.turn_acceleration, 0.1, 100.0);
  CheckRange("drive.reach", options.drive.reach, 0.01, 10.0);
  CheckRange("lidar.beams.num_beams", options.lidar.beams.num_beams, 1, 10000);
  CheckRange("lidar.max_range", options.lidar.max_range, 0.1, 80.0);
  CheckRange("lidar.range_noise", options.lidar.range_noise, 0.0, 1.0);
  CheckRange("lidar.range_step", options.lidar.range_step, 1e-4, 1.0);
  CheckRange("lidar.dropout_probability", options.lidar.dropout_probability, 0.0, 1.0);
  const WheelOdometryOptions& wheels = options.wheel_odometry;
  CheckRange("wheel_odometry.distance_scale", wheels.distance_scale, 0.0, 10.0);
  CheckRange("wheel_odometry.turn_scale", wheels.turn_scale, 0.0, 10.0);
  CheckRange("wheel_odometry.turn_per_meter", wheels.turn_per_meter, -10.0, 10.0);
  CheckRange("wheel_odometry.distance_noise", wheels.distance_noise, 0.0, 10.0);
  CheckRange("wheel_odometry.turn_noise", wheels.turn_noise, 0.0, 10.0);
  CheckRange("wheel_odometry.turn_noise_of_turn", wheels.turn_noise_of_turn, 0.0, 10.0);
}

}  // namespace

Simulation Simulate(const World& world, const SimulationOptions& options) {
  Check(options);
  // Noise of its own for each sensor, so that one can be changed without the other.
  Random lidar_random(options.seed);
  Random odometry_random(~options.seed);
  const RayCaster ray_caster(world.plan);
  WheelOdometry odometry(options.wheel_odometry);

  Simulation simulation;
  simulation.ground_truth =
      Drive(world.route, options.drive, options.scan_period / options.odometry_readings_per_scan);
  ScanLog& log = simulation.log;
  log.name = world.name;
  log.beam_geometries = {options.lidar.beams};
  log.base_from_laser = Pose2(options.laser_offset, 0.0, 0.0);
  Pose2 world_from_old = simulation.ground_truth.front().map_from_base;
  for (TimedPose& pose : simulation.ground_truth) {
    pose.time += options.start_time;
    const Pose2& world_from_base = pose.map_from_base;
    odometry.Move(world_from_old.Inverse() * world_from_base, &odometry_random);
    world_from_old = world_from_base;
    log.odometry.push_back({pose.time, odometry.odom_from_base()});
    const int num_readings = static_cast<int>(log.odometry.size());
    if ((num_readings - 1) % options.odometry_readings_per_scan != 0) continue;
    log.scans.push_back({pose.time, 0,
                         SimulateScan(ray_caster, world_from_base * log.base_from_laser,
                                      options.lidar, &lidar_random),
                         num_readings});
  }
  return simulation;
}

}  // namespace loopscope
