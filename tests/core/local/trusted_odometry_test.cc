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

/// The robot of the small loop, whose scan at kOddScan shows what it sees only at `seen_at`.
ScanLog LogWithAnOddScan(const Simulation& simulation, int seen_at) {
  ScanLog log = simulation.log;
  log.scans.resize(kOddScan + 5);
  log.scans[kOddScan].ranges = simulation.log.scans[seen_at].ranges;
  return log;
}

TEST(TrustedOdometry, HoldsAScanThatMatchesElsewhere) {
  const Simulation simulation = SimulateSmallLoop();
  for (const int seen_at : {30, 50, 66, 86, 110}) {
    const auto results = AddAllScans(LogWithAnOddScan(simulation, seen_at),
                                     SmallLoopOptions().trajectory_builder_2d);
    EXPECT_NE(results[kOddScan].match_start, MatchStart::kRecovery) << seen_at;
    EXPECT_THAT(Motion(results, kOddScan - 1, kOddScan),
                PoseNear(TrueMotion(simulation, kOddScan - 1, kOddScan), 0.1, 0.1))
        << seen_at;
  }
}

TEST(TrustedOdometry, IsNotThatWhichJumped) {
  const Simulation simulation = SimulateSmallLoop();
  ScanLog log = LogWithAnOddScan(simulation, 66);
  JumpOdometry(kOddScan, Pose2(0.0, 0.0, 1.5), &log);
  const auto results = AddAllScans(log, SmallLoopOptions().trajectory_builder_2d);
  EXPECT_EQ(results[kOddScan].match_start, MatchStart::kRecovery);
}

}  // namespace
}  // namespace loopscope
