// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include <gtest/gtest.h>

#include "core/local/local_slam.h"
#include "tests/support/local_run.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr int kOddScan = 60;
constexpr int kSeenLater = 70;  // half a metre and a turn on

/// The robot of the small loop, whose scan at kOddScan shows what it sees only at kSeenLater.
ScanLog LogWithAnOddScan(const Simulation& simulation) {
  ScanLog log = simulation.log;
  log.scans.resize(kOddScan + 5);
  log.scans[kOddScan].ranges = simulation.log.scans[kSeenLater].ranges;
  return log;
}

Options OptionsThatDoubtTheScan() {
  Options options = SmallLoopOptions();
  options.trajectory_builder_2d.recovery.min_relative_score = 0.8;
  return options;
}

TEST(TrustedOdometry, HoldsAScanThatMatchesElsewhere) {
  const Simulation simulation = SimulateSmallLoop();
  const auto results =
      AddAllScans(LogWithAnOddScan(simulation), OptionsThatDoubtTheScan().trajectory_builder_2d);
  EXPECT_NE(results[kOddScan].match_start, MatchStart::kRecovery);
  EXPECT_THAT(Motion(results, kOddScan - 1, kOddScan),
              PoseNear(TrueMotion(simulation, kOddScan - 1, kOddScan), 0.1, 0.05));
}

TEST(TrustedOdometry, IsNotThatWhichJumped) {
  const Simulation simulation = SimulateSmallLoop();
  ScanLog log = LogWithAnOddScan(simulation);
  JumpOdometry(kOddScan, Pose2(0.0, 0.0, 1.5), &log);
  const auto results = AddAllScans(log, OptionsThatDoubtTheScan().trajectory_builder_2d);
  EXPECT_NE(results[kOddScan].match_start, MatchStart::kNone);
}

}  // namespace
}  // namespace loopscope
