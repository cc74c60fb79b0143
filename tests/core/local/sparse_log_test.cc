// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// Local SLAM of logs with a scan every metre or five.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "core/local/local_slam.h"
#include "core/simulation/worlds.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

Simulation SparseLog(const std::string& world, double scan_period) {
  SimulationOptions options;
  options.scan_period = scan_period;
  return Simulate(MakeWorld(world), options);
}

/// The largest of the errors of the motion from one scan to the next [m].
double WorstStep(const Simulation& simulation, const LocalSlamOptions& options) {
  const ScanLog& log = simulation.log;
  LocalSlam slam(log, options);
  const auto truth = [&](int scan) {
    return PoseAt(simulation.ground_truth, log.scans[scan].time);
  };
  Pose2 before = slam.AddScan(0).local_from_base;
  double worst = 0.0;
  for (int scan = 1; scan < static_cast<int>(log.scans.size()); ++scan) {
    const Pose2 now = slam.AddScan(scan).local_from_base;
    const Pose2 true_motion = truth(scan - 1).Inverse() * truth(scan);
    const Pose2 error = true_motion.Inverse() * (before.Inverse() * now);
    worst = std::max(worst, error.translation.norm());
    before = now;
  }
  return worst;
}

// The robot sees a new corridor, which looks as the old one did from where it came, and better than
// where odometry has it, for of the new one nothing is known.
TEST(LocalSlamOfSparseLogs, TurnsCornersAsOdometryMeasuredThem) {
  for (const double scan_period : {2.0, 3.0}) {
    for (const char* const world : {"loop", "hotel"}) {
      EXPECT_LT(WorstStep(SparseLog(world, scan_period), LoopscopePreset().trajectory_builder_2d),
                0.5)
          << world << ", " << scan_period;
    }
  }
}

/// Of the first `num_scans` scans, where it differs at all.
bool WideWallsMakeADifference(ScanLog log, int num_scans) {
  log.scans.resize(num_scans);
  LocalSlamOptions wide = LoopscopePreset().trajectory_builder_2d;
  LocalSlamOptions as_they_are = wide;
  as_they_are.share_beside_walls = 0.0;
  LocalSlam with_wide_walls(log, wide);
  LocalSlam with_walls_as_they_are(log, as_they_are);
  for (int scan = 0; scan < num_scans; ++scan) {
    if (with_wide_walls.AddScan(scan).local_from_base !=
        with_walls_as_they_are.AddScan(scan).local_from_base) {
      return true;
    }
  }
  return false;
}

TEST(LocalSlamOfSparseLogs, MatchesWithWideWallsUnlikeThatOfOthers) {
  EXPECT_TRUE(WideWallsMakeADifference(SparseLog("loop", 1.0).log, 40));
  EXPECT_FALSE(WideWallsMakeADifference(SparseLog("loop", 0.2).log, 200));
}

}  // namespace
}  // namespace loopscope
