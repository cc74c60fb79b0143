// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/local/local_slam.h"
#include "core/simulation/simulate.h"

namespace loopscope {

inline std::vector<LocalSlamResult> AddAllScans(const ScanLog& log,
                                                const LocalSlamOptions& options) {
  LocalSlam slam(log, options);
  std::vector<LocalSlamResult> results;
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    results.push_back(slam.AddScan(scan));
  }
  return results;
}

/// Lets odometry believe that the robot made `motion` just before `scan`, besides what it did.
inline void JumpOdometry(int scan, const Pose2& motion, ScanLog* log) {
  const int first = log->scans[scan].num_odometry_before - 1;
  const Pose2 odom_from_base = log->odometry[first].odom_from_base;
  const Pose2 jump = odom_from_base * motion * odom_from_base.Inverse();
  for (std::size_t i = first; i < log->odometry.size(); ++i) {
    log->odometry[i].odom_from_base = jump * log->odometry[i].odom_from_base;
  }
}

/// The true motion of the robot between two scans.
inline Pose2 TrueMotion(const Simulation& simulation, int from, int to) {
  const auto world_from_base = [&](int scan) {
    return PoseAt(simulation.ground_truth, simulation.log.scans[scan].time);
  };
  return world_from_base(from).Inverse() * world_from_base(to);
}

/// As local SLAM has it.
inline Pose2 Motion(const std::vector<LocalSlamResult>& results, int from, int to) {
  return results[from].local_from_base.Inverse() * results[to].local_from_base;
}

}  // namespace loopscope
