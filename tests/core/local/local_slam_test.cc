// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/local_slam.h"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/local_run.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

using ::testing::Not;

Simulation FirstScans(int num_scans) {
  Simulation simulation = SimulateSmallLoop();
  simulation.log.scans.resize(num_scans);
  return simulation;
}

Pose2 Turn(double degrees) { return {0.0, 0.0, DegreesToRadians(degrees)}; }

TEST(LocalSlam, BeginsWhereTheLocalFrameDoes) {
  const Simulation simulation = FirstScans(1);
  const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
  EXPECT_EQ(results[0].local_from_base, Pose2());
  ASSERT_TRUE(results[0].insertion);
  EXPECT_EQ(results[0].insertion->first_submap, SubmapId{0});
}

TEST(LocalSlam, FollowsTheTruthMuchCloserThanOdometryDoes) {
  const Simulation simulation = FirstScans(80);
  const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
  const Trajectory odometry = OdometryTrajectoryOf(simulation.log);
  const Pose2 truth = TrueMotion(simulation, 0, 79);
  EXPECT_THAT(Motion(results, 0, 79), PoseNear(truth, 0.1, DegreesToRadians(2.0)));
  EXPECT_THAT(odometry[79].map_from_base, Not(PoseNear(truth, 0.5, DegreesToRadians(10.0))));
}

TEST(LocalSlam, FollowsTheTruthWithoutOdometry) {
  // With a view all around, so that no corridor is without an end in sight.
  SimulationOptions simulation_options;
  simulation_options.lidar.beams = {361, -M_PI, DegreesToRadians(1.0)};
  Simulation simulation = Simulate(SmallLoopWorld(), simulation_options);
  simulation.log.scans.resize(60);
  simulation.log.odometry.clear();
  for (LaserScan& scan : simulation.log.scans) scan.num_odometry_before = 0;
  const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
  EXPECT_FALSE(results.back().odom_from_base);
  EXPECT_THAT(Motion(results, 0, 59),
              PoseNear(TrueMotion(simulation, 0, 59), 0.05, DegreesToRadians(1.0)));
}

TEST(LocalSlam, LeavesOdometryAsideIfToldSo) {
  const Simulation simulation = FirstScans(20);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.use_odometry = false;
  ScanLog without = simulation.log;
  for (LaserScan& scan : without.scans) scan.num_odometry_before = 0;
  const auto results = AddAllScans(simulation.log, options);
  const auto expected = AddAllScans(without, options);
  for (std::size_t i = 0; i < results.size(); ++i) {
    EXPECT_FALSE(results[i].odom_from_base);
    EXPECT_EQ(results[i].local_from_base, expected[i].local_from_base) << i;
  }
}

TEST(LocalSlam, CarriesOnBlindlyOverScansWithoutReturns) {
  Simulation simulation = FirstScans(30);
  for (int scan = 10; scan < 15; ++scan) {
    for (float& range : simulation.log.scans[scan].ranges) {
      range = std::numeric_limits<float>::infinity();
    }
  }
  const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
  for (int scan = 10; scan < 15; ++scan) {
    EXPECT_FALSE(results[scan].has_returns);
    EXPECT_FALSE(results[scan].insertion);
    EXPECT_EQ(results[scan].local_from_base, results[scan].local_from_base_prior);
  }
  EXPECT_TRUE(results[15].has_returns);
  EXPECT_THAT(Motion(results, 0, 29),
              PoseNear(TrueMotion(simulation, 0, 29), 0.1, DegreesToRadians(2.0)));
}

constexpr int kJumpScan = 60;

TEST(LocalSlam, RecoversFromAnOdometryJumpOf85Degrees) {
  for (const int jump : {2, kJumpScan}) {
    Simulation simulation = FirstScans(jump + 20);
    JumpOdometry(jump, Turn(85.0), &simulation.log);
    const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
    for (const int scan : {jump, jump + 19}) {
      EXPECT_THAT(Motion(results, jump - 1, scan),
                  PoseNear(TrueMotion(simulation, jump - 1, scan), 0.1, DegreesToRadians(2.0)))
          << jump << " " << scan;
    }
  }
}

TEST(LocalSlam, GoesOnWhereOdometryLeaps) {
  const Simulation simulation = FirstScans(kJumpScan + 20);
  for (const double leap : {2e8, 1e300}) {
    ScanLog log = simulation.log;
    JumpOdometry(kJumpScan, Pose2(leap, 0.0, 0.0), &log);
    const auto results = AddAllScans(log, SmallLoopOptions().trajectory_builder_2d);
    EXPECT_FALSE(results[kJumpScan].odom_from_base);
    EXPECT_THAT(
        Motion(results, kJumpScan - 1, kJumpScan),
        PoseNear(TrueMotion(simulation, kJumpScan - 1, kJumpScan), 0.1, DegreesToRadians(2.0)));
  }
}

TEST(LocalSlam, EndsWhereNoMapReaches) {
  ScanLog log = FirstScans(1).log;
  const LaserScan first = log.scans[0];
  for (int i = 0; i < 12'000; ++i) {
    log.scans.push_back(first);
    log.scans.back().ranges.assign(first.ranges.size(), std::numeric_limits<float>::infinity());
    log.odometry.resize(first.num_odometry_before + i);
    log.odometry.push_back({first.time, Pose2(90.0 * (i + 1), 0.0, 0.0)});
    log.scans.back().num_odometry_before = static_cast<int>(log.odometry.size());
  }
  LocalSlam slam(log, SmallLoopOptions().trajectory_builder_2d);
  int scan = 0;
  const auto add_all = [&] {
    for (; scan < static_cast<int>(log.scans.size()); ++scan) slam.AddScan(scan);
  };
  EXPECT_THROW(add_all(), std::length_error);
  EXPECT_NEAR(scan, 11'111, 3) << "1000 km";
}

TEST(LocalSlam, GoesOnWhereOdometryHangs) {
  constexpr int kNumScans = 20;
  const Simulation simulation = FirstScans(kJumpScan + kNumScans);
  ScanLog log = simulation.log;
  for (int i = 0; i < kNumScans; ++i) {
    log.scans[kJumpScan + i].num_odometry_before = log.scans[kJumpScan].num_odometry_before;
  }
  const int last = kJumpScan + kNumScans - 1;
  const Pose2 truth = TrueMotion(simulation, kJumpScan, last);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.max_changed_share_at_standstill = 1.0;
  options.second_prior_relative_score = 0.0;
  options.recovery.min_relative_score = 0.0;
  options.recovery.unmeasured_min_relative_score = 0.0;
  EXPECT_THAT(Motion(AddAllScans(log, options), kJumpScan, last),
              PoseNear(truth, 0.1, DegreesToRadians(2.0)));
  options.standstill_min_score_ratio = 0.0;
  EXPECT_THAT(Motion(AddAllScans(log, options), kJumpScan, last),
              Not(PoseNear(truth, 0.5, DegreesToRadians(20.0))));
}

TEST(LocalSlam, TellsWhatItKnowsOfTheMotion) {
  Simulation simulation = FirstScans(kJumpScan + 1);
  JumpOdometry(kJumpScan, Turn(85.0), &simulation.log);
  const LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  const auto results = AddAllScans(simulation.log, options);
  EXPECT_FALSE(results[0].motion_knowledge.is_known) << "nothing was there to match";
  int num_held = 0;
  for (int scan = 1; scan < kJumpScan; ++scan) {
    if (results[scan].match_start != MatchStart::kPrior) continue;
    EXPECT_TRUE(results[scan].motion_knowledge.is_known) << scan;
    num_held += results[scan].motion_knowledge.way_is_held ? 1 : 0;
  }
  EXPECT_GT(num_held, 20);
  EXPECT_FALSE(results[kJumpScan].motion_knowledge.way_is_held) << "odometry says otherwise";
  EXPECT_TRUE(results[kJumpScan].motion_knowledge.is_known) << "it fits only there";
}

TEST(LocalSlam, UsesNoOdometryThatHangs) {
  constexpr int kHangScan = 75;  // the robot turns
  ScanLog log = FirstScans(kHangScan + 3).log;
  log.scans[kHangScan].num_odometry_before = log.scans[kHangScan - 1].num_odometry_before;
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.max_changed_share_at_standstill = 0.05;
  const auto results = AddAllScans(log, options);
  EXPECT_FALSE(results[kHangScan].odom_from_base);
  EXPECT_TRUE(results[kHangScan + 1].odom_from_base);
  options.max_changed_share_at_standstill = 1.0;
  EXPECT_TRUE(AddAllScans(log, options)[kHangScan].odom_from_base);
}

TEST(LocalSlam, TakesTheMotionSinceOdometryHungForUnmeasured) {
  constexpr int kHangScan = 75;
  ScanLog log = FirstScans(kHangScan + 3).log;
  log.scans[kHangScan].num_odometry_before = log.scans[kHangScan - 1].num_odometry_before;
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.max_changed_share_at_standstill = 0.05;
  options.use_online_correlative_scan_matching = false;
  options.ceres_scan_matcher.translation_weight = 1e6;  // nothing that was measured moves
  options.unmeasured_prior_scale = 1e6;
  const auto results = AddAllScans(log, options);
  const auto moved = [&](int scan) {
    return (results[scan].local_from_base.translation -
            results[scan].local_from_base_prior.translation)
        .norm();
  };
  EXPECT_LT(moved(kHangScan - 1), 1e-5);
  EXPECT_GT(moved(kHangScan), 1e-3);
  EXPECT_GT(moved(kHangScan + 1), 1e-3);
  EXPECT_LT(moved(kHangScan + 2), 1e-5);
}

/// The motion from before an odometry jump of 85 deg until 20 scans after it, without recovery.
Pose2 MotionOverJumpWithoutRecovery(const Simulation& simulation,
                                    double second_prior_relative_score,
                                    double unusual_motion_min_score_ratio) {
  ScanLog log = simulation.log;
  JumpOdometry(kJumpScan, Turn(85.0), &log);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.recovery.min_relative_score = 0.0;
  options.second_prior_relative_score = second_prior_relative_score;
  options.unusual_motion_min_score_ratio = unusual_motion_min_score_ratio;
  return Motion(AddAllScans(log, options), kJumpScan - 1, kJumpScan + 19);
}

TEST(LocalSlam, IsLostAfterAnOdometryJumpOf85DegreesIfItOnlyBelievesOdometry) {
  const Simulation simulation = FirstScans(kJumpScan + 20);
  const Pose2 truth = TrueMotion(simulation, kJumpScan - 1, kJumpScan + 19);
  EXPECT_THAT(MotionOverJumpWithoutRecovery(simulation, 0.0, 0.0),
              Not(PoseNear(truth, 0.5, DegreesToRadians(45.0))));
  EXPECT_THAT(MotionOverJumpWithoutRecovery(simulation, 0.8, 0.0),
              PoseNear(truth, 0.1, DegreesToRadians(2.0)))
      << "the velocity knows better";
  EXPECT_THAT(MotionOverJumpWithoutRecovery(simulation, 0.0, 1.2),
              PoseNear(truth, 0.1, DegreesToRadians(2.0)))
      << "it never turned like that";
  EXPECT_THAT(MotionOverJumpWithoutRecovery(simulation, 0.0, 10.0),
              Not(PoseNear(truth, 0.5, DegreesToRadians(45.0))))
      << "it does not match ten times as well elsewhere";
}

TEST(LocalSlam, BelievesOdometryOfAnUnusualMotionIfTheScansAheadDo) {
  // The robot goes 3 m on where it had always gone 0.8 m, and the scan there is that of before.
  SimulationOptions simulation_options;
  simulation_options.scan_period = 1.0;
  Simulation simulation = Simulate(SmallLoopWorld(), simulation_options);
  constexpr int kLeap = 30;
  std::vector<LaserScan>& scans = simulation.log.scans;
  scans.erase(scans.begin() + kLeap, scans.begin() + kLeap + 3);
  scans.resize(kLeap + 4);
  scans[kLeap].ranges = scans[kLeap - 1].ranges;
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.recovery.min_relative_score = 0.0;
  options.second_prior_relative_score = 0.0;
  const auto results = AddAllScans(simulation.log, options);
  EXPECT_THAT(Motion(results, kLeap - 1, kLeap),
              PoseNear(TrueMotion(simulation, kLeap - 1, kLeap), 0.5, DegreesToRadians(5.0)));
}

constexpr int kNumScansInCrowd = 4;

/// From kJumpScan on some scans see people close around the robot and nothing else, while odometry
/// measures a turn of 16 deg too much.
ScanLog LogThroughCrowd(const Simulation& simulation) {
  ScanLog log = simulation.log;
  for (int i = 0; i < kNumScansInCrowd; ++i) {
    SeePeopleAround(i, &log.scans[kJumpScan + i]);
    JumpOdometry(kJumpScan + i, Turn(4.0), &log);
  }
  return log;
}

TEST(LocalSlam, PlacesScansThatMatchNowhereByTheNextOneThatDoes) {
  const Simulation simulation = FirstScans(kJumpScan + 10);
  const ScanLog log = LogThroughCrowd(simulation);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  const auto error = [&](const std::vector<LocalSlamResult>& results, int scan) {
    return std::abs(RadiansToDegrees((TrueMotion(simulation, kJumpScan - 1, scan).Inverse() *
                                      Motion(results, kJumpScan - 1, scan))
                                         .rotation));
  };
  const int last_in_crowd = kJumpScan + kNumScansInCrowd - 1;

  options.recovery.max_num_scans_ahead = kNumScansInCrowd;
  const auto placed = AddAllScans(log, options);
  for (int scan = kJumpScan; scan <= last_in_crowd; ++scan) {
    EXPECT_EQ(placed[scan].match_start, MatchStart::kAhead) << scan;
    EXPECT_LT(error(placed, scan), 3.0) << scan;
  }
  EXPECT_LT(error(placed, last_in_crowd + 5), 2.0);

  for (const int too_few : {0, kNumScansInCrowd - 1}) {
    options.recovery.max_num_scans_ahead = too_few;
    const auto left = AddAllScans(log, options);
    EXPECT_EQ(left[kJumpScan].match_start, MatchStart::kNone);
    EXPECT_EQ(left[kJumpScan].local_from_base, left[kJumpScan].local_from_base_prior);
  }
  options.recovery.max_num_scans_ahead = 0;
  EXPECT_GT(error(AddAllScans(log, options), last_in_crowd), 12.0);
}

TEST(LocalSlam, StaysWhereItWasIfNothingTellsWhereItIs) {
  const Simulation simulation = FirstScans(kJumpScan + 10);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.use_odometry = false;
  options.past_motions_weight = 0.0;
  const auto results = AddAllScans(LogThroughCrowd(simulation), options);
  for (int scan = kJumpScan; scan < kJumpScan + kNumScansInCrowd; ++scan) {
    EXPECT_EQ(results[scan].match_start, MatchStart::kNone) << scan;
    EXPECT_EQ(results[scan].local_from_base, results[scan - 1].local_from_base) << scan;
  }
}

TEST(LocalSlam, IsWhereTheMotionsBeforeHaveItIfNothingElseTells) {
  const Simulation simulation = FirstScans(kJumpScan + kNumScansInCrowd);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  options.use_odometry = false;
  // Every second scan before is missing, so that the motions are long.
  ScanLog log = LogThroughCrowd(simulation);
  for (int scan = kJumpScan - 1; scan > 0; scan -= 2) log.scans.erase(log.scans.begin() + scan);
  constexpr int kFirstInCrowd = kJumpScan / 2;
  const auto results = AddAllScans(log, options);
  EXPECT_EQ(results[kFirstInCrowd].match_start, MatchStart::kMotions);
  EXPECT_FALSE(results[kFirstInCrowd].motion_knowledge.is_known);
  EXPECT_NE(results[kFirstInCrowd].local_from_base, results[kFirstInCrowd - 1].local_from_base);
}

TEST(LocalSlam, IsTheSameWithRecoveryWhereNothingGoesWrong) {
  const Simulation simulation = FirstScans(80);
  LocalSlamOptions options = SmallLoopOptions().trajectory_builder_2d;
  const auto with = AddAllScans(simulation.log, options);
  options.recovery.min_relative_score = 0.0;
  const auto without = AddAllScans(simulation.log, options);
  for (std::size_t i = 0; i < with.size(); ++i) {
    EXPECT_EQ(with[i].local_from_base, without[i].local_from_base) << i;
  }
}

TEST(LocalSlam, InsertsOnlyWhereTheRobotMoved) {
  Simulation simulation = FirstScans(30);
  // The robot stands still from scan 20 on, and sees the same.
  for (int scan = 21; scan < 30; ++scan) {
    simulation.log.scans[scan].ranges = simulation.log.scans[20].ranges;
    simulation.log.scans[scan].num_odometry_before = simulation.log.scans[20].num_odometry_before;
  }
  const auto results = AddAllScans(simulation.log, SmallLoopOptions().trajectory_builder_2d);
  int num_inserted = 0;
  for (int scan = 21; scan < 30; ++scan) num_inserted += results[scan].insertion ? 1 : 0;
  EXPECT_LE(num_inserted, 1);
  EXPECT_TRUE(results[25].has_returns);
}

}  // namespace
}  // namespace loopscope
