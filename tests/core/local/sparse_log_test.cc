// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// Local SLAM of logs with a scan every metre or five.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/simulation/worlds.h"
#include "tests/support/local_run.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

using ::testing::Not;

Simulation SparseLog(const std::string& world, double scan_period) {
  SimulationOptions options;
  options.scan_period = scan_period;
  return Simulate(MakeWorld(world), options);
}

/// The largest of the errors of the motion from one scan to the next [m].
double WorstStep(const Simulation& simulation, const LocalSlamOptions& options) {
  const auto results = AddAllScans(simulation.log, options);
  double worst = 0.0;
  for (int scan = 1; scan < static_cast<int>(results.size()); ++scan) {
    const Pose2 error =
        TrueMotion(simulation, scan - 1, scan).Inverse() * Motion(results, scan - 1, scan);
    worst = std::max(worst, error.translation.norm());
  }
  return worst;
}

TEST(LocalSlamOfSparseLogs, GoesOnByTheMotionsBefore) {
  SimulationOptions simulation_options;
  simulation_options.scan_period = 1.0;  // 0.8 m
  simulation_options.lidar.beams = {361, -M_PI, DegreesToRadians(1.0)};
  const Simulation simulation = Simulate(SmallLoopWorld(), simulation_options);
  constexpr int kHangScan = 21;
  ScanLog log = simulation.log;
  const int last = static_cast<int>(log.scans.size()) - 1;
  for (int scan = kHangScan; scan <= last; ++scan) {
    log.scans[scan].num_odometry_before = log.scans[kHangScan].num_odometry_before;
  }
  const Pose2 truth = TrueMotion(simulation, kHangScan, last);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.recovery.unmeasured_min_relative_score = 0.0;
  const auto results = AddAllScans(log, options);
  EXPECT_EQ(results[last].match_start, MatchStart::kRecovery);
  EXPECT_THAT(Motion(results, kHangScan, last), PoseNear(truth, 0.1, DegreesToRadians(2.0)));
  options.past_motions_weight = 0.0;
  EXPECT_THAT(Motion(AddAllScans(log, options), kHangScan, last),
              Not(PoseNear(truth, 0.5, DegreesToRadians(20.0))));
}

TEST(LocalSlamOfSparseLogs, FollowsThemWithoutOdometryFromTheFirstScanOn) {
  SimulationOptions simulation_options;
  simulation_options.scan_period = 1.5;  // 1.2 m
  simulation_options.lidar.beams = {361, -M_PI, DegreesToRadians(1.0)};
  const Simulation simulation = Simulate(SmallLoopWorld(), simulation_options);
  ScanLog log = simulation.log;
  constexpr int kLast = 15;
  log.scans.resize(kLast + 1);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.use_odometry = false;
  const Pose2 truth = TrueMotion(simulation, 0, kLast);
  EXPECT_THAT(Motion(AddAllScans(log, options), 0, kLast),
              PoseNear(truth, 0.1, DegreesToRadians(2.0)));
  options.past_motions_weight = 0.0;
  EXPECT_THAT(Motion(AddAllScans(log, options), 0, kLast),
              Not(PoseNear(truth, 0.5, DegreesToRadians(20.0))));
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

// Where a scan is missing, the robot goes round a corner as it never did before, by 1.7 m and 40
// deg. The next one fits where odometry has it, but those ahead look down a corridor like the old
// one.
TEST(LocalSlamOfSparseLogs, DoubtsNoUnusualMotionToWhereTheScanFits) {
  Simulation simulation = SparseLog("office", 1.2);
  std::vector<LaserScan>& scans = simulation.log.scans;
  constexpr int kNumScans = 60;
  scans.resize(kNumScans);
  for (int scan = kNumScans - 8; scan >= 0; scan -= 10) scans.erase(scans.begin() + scan);
  EXPECT_LT(WorstStep(simulation, LoopscopePreset().trajectory_builder_2d), 0.5);
}

constexpr int kJumpScan = 40;

/// `loop` with a scan every second, up to shortly after a jump.
Simulation LogUpToJump() {
  Simulation simulation = SparseLog("loop", 1.0);
  simulation.log.scans.resize(kJumpScan + 5);
  return simulation;
}

/// Lets odometry believe that the robot made `motion` before kJumpScan.
void JumpBy(const Pose2& motion, ScanLog* log) {
  const auto odom_from_base = [log](int scan) {
    return log->odometry[log->scans[scan].num_odometry_before - 1].odom_from_base;
  };
  const Pose2 now_from_before = odom_from_base(kJumpScan).Inverse() * odom_from_base(kJumpScan - 1);
  JumpOdometry(kJumpScan, now_from_before * motion, log);
}

// The scan matches nowhere, wherever odometry has it. Neither does it where the robot would be had
// it gone on, but there the scans ahead do.
TEST(LocalSlamOfSparseLogs, DoubtsAJumpToWhereNothingMatches) {
  Simulation simulation = LogUpToJump();
  ScanLog& log = simulation.log;
  std::vector<float>& ranges = log.scans[kJumpScan].ranges;  // people stand around the robot
  for (std::size_t i = 0; i < ranges.size(); ++i) ranges[i] = i / 30 % 2 == 0 ? 0.7F : 0.9F;
  JumpBy(Pose2(-0.5, 1.0, 0.5), &log);
  const auto results = AddAllScans(log, LoopscopePreset().trajectory_builder_2d);
  EXPECT_EQ(results[kJumpScan].match_start, MatchStart::kMotions);
  EXPECT_FALSE(results[kJumpScan].motion_knowledge.is_known);
  EXPECT_THAT(Motion(results, kJumpScan - 1, kJumpScan + 1),
              PoseNear(TrueMotion(simulation, kJumpScan - 1, kJumpScan + 1), 0.3, 0.1));
}

TEST(LocalSlamOfSparseLogs, DoubtsAJumpThatLooksLikeAnyMotionIfNothingMatchesThere) {
  Simulation simulation = LogUpToJump();
  const auto turn = [&](int scan) { return TrueMotion(simulation, scan - 1, scan).rotation; };
  int corner = 1;
  for (int scan = 1; scan < kJumpScan; ++scan) {
    if (std::abs(turn(scan)) > std::abs(turn(corner))) corner = scan;
  }
  JumpBy(TrueMotion(simulation, corner - 1, corner), &simulation.log);
  LocalSlamOptions options = LoopscopePreset().trajectory_builder_2d;
  options.recovery.min_gain = 1.0;  // neither the wide search nor the velocity is believed
  options.second_prior_relative_score = 0.0;
  const auto results = AddAllScans(simulation.log, options);
  EXPECT_EQ(results[kJumpScan].match_start, MatchStart::kRecovery);
  EXPECT_THAT(Motion(results, kJumpScan - 1, kJumpScan),
              PoseNear(TrueMotion(simulation, kJumpScan - 1, kJumpScan), 0.1, 0.05));
}

/// To any of the first `num_scans` scans.
bool WideWallsMakeADifference(ScanLog log, int num_scans) {
  log.scans.resize(num_scans);
  LocalSlamOptions options = LoopscopePreset().trajectory_builder_2d;
  const auto with_wide_walls = AddAllScans(log, options);
  options.share_beside_walls = 0.0;
  const auto with_walls_as_they_are = AddAllScans(log, options);
  return !std::equal(with_wide_walls.begin(), with_wide_walls.end(), with_walls_as_they_are.begin(),
                     [](const LocalSlamResult& a, const LocalSlamResult& b) {
                       return a.local_from_base == b.local_from_base;
                     });
}

TEST(LocalSlamOfSparseLogs, MatchesWithWideWallsUnlikeThatOfOthers) {
  EXPECT_TRUE(WideWallsMakeADifference(SparseLog("loop", 1.0).log, 40));
  EXPECT_FALSE(WideWallsMakeADifference(SparseLog("loop", 0.2).log, 200));
}

}  // namespace
}  // namespace loopscope
