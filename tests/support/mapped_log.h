// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/simulation/simulate.h"
#include "core/slam/slam.h"
#include "core/slam/state.h"

namespace loopscope {

/// A ring of corridors, 10 m x 8 m, in which no place looks like another; one round and a half.
inline World SmallLoopWorld() {
  World world;
  world.name = "small_loop";
  FloorPlan& plan = world.plan;
  plan.AddRoom({0.0, 0.0}, {10.0, 8.0});
  plan.AddRoom({2.0, 2.0}, {8.0, 6.0});
  plan.AddBox(Pose2(3.2, 0.2, 0.0), {0.6, 0.4});
  plan.AddBox(Pose2(6.1, 1.85, 0.0), {1.0, 0.3});
  plan.AddBox(Pose2(9.8, 3.1, 0.0), {0.4, 0.7});
  plan.AddPillar({8.2, 5.2}, 0.2);
  plan.AddBox(Pose2(6.5, 7.7, 0.3), {1.1, 0.5});
  plan.AddPillar({3.4, 7.6}, 0.25);
  plan.AddBox(Pose2(0.2, 5.0, 0.0), {0.4, 0.9});
  plan.AddBox(Pose2(1.9, 3.2, 0.2), {0.3, 0.6});
  world.route = {{2.0, 1.1}, {9.0, 1.1}, {9.0, 7.0}, {1.0, 7.0},
                 {1.0, 1.0}, {9.0, 1.1}, {9.0, 4.0}};
  return world;
}

/// Some 200 scans of 181 beams through the small loop, with wheels that go wrong by metres.
inline Simulation SimulateSmallLoop(std::uint64_t seed = 1) {
  SimulationOptions options;
  options.seed = seed;
  options.scan_period = 0.25;
  options.lidar.beams = {181, DegreesToRadians(-90.0), DegreesToRadians(1.0)};
  options.wheel_odometry.turn_scale = 1.05;
  options.wheel_odometry.turn_per_meter = 0.02;
  return Simulate(SmallLoopWorld(), options);
}

/// Our preset with submaps small enough for the small loop to have many.
inline Options SmallLoopOptions() {
  Options options = LoopscopePreset();
  options.trajectory_builder_2d.submaps.num_range_data = 8;
  options.pose_graph.optimize_every_n_nodes = 8;
  return options;
}

/// Lets a scan see people close around the robot and nothing else, elsewhere for each `pattern`.
inline void SeePeopleAround(int pattern, LaserScan* scan) {
  for (std::size_t beam = 0; beam < scan->ranges.size(); ++beam) {
    scan->ranges[beam] = 0.5F + 0.07F * static_cast<float>((7 * beam + 5 * pattern) % 11);
  }
}

inline Recording MapLog(const ScanLog& log, const Options& options, int num_threads = 1) {
  Recording recording(log, options);
  Slam slam(recording.log(), recording.options(), num_threads);
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    recording.Append(slam.AddScan(scan));
  }
  return recording;
}

/// Where the robot was at each scan, as the end of the run has it. Needs at least one step.
inline Trajectory TrajectoryOf(const Recording& recording) {
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  Trajectory trajectory;
  for (int step = 0; step < recording.num_steps(); ++step) {
    trajectory.push_back(
        {recording.log().scans[step].time, GlobalFromBase(recording, state, step)});
  }
  return trajectory;
}

/// Where the robot was at each scan if odometry were right.
inline Trajectory OdometryTrajectoryOf(const ScanLog& log) {
  Trajectory trajectory;
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    trajectory.push_back({log.scans[scan].time, OdometryOfScan(log, scan)->odom_from_base});
  }
  return trajectory;
}

}  // namespace loopscope
