// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/slam.h"

#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/evaluation/trajectory_error.h"
#include "core/io/recording_hash.h"
#include "core/slam/derive.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

int NumCandidates(const Recording& recording, Verdict verdict) {
  int count = 0;
  for (const LoopCandidate& c : recording.candidates()) count += c.verdict == verdict ? 1 : 0;
  return count;
}

class SlamInTheSmallLoop : public ::testing::TestWithParam<std::uint64_t> {};

INSTANTIATE_TEST_SUITE_P(Seeds, SlamInTheSmallLoop, ::testing::Values(1, 2, 3));

TEST_P(SlamInTheSmallLoop, IsWithin5CentimetresWhereOdometryIsOffByMetres) {
  const Simulation simulation = SimulateSmallLoop(GetParam());
  const Recording recording = MapLog(simulation.log, SmallLoopOptions());
  const auto odometry =
      EvaluateTrajectory(simulation.ground_truth, OdometryTrajectoryOf(simulation.log));
  EXPECT_GT(odometry->translation.rmse, 1.0);
  const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
  EXPECT_LT(error->translation.rmse, 0.05);
  EXPECT_LT(error->rotation.rmse, DegreesToRadians(1.0));
  EXPECT_GT(NumCandidates(recording, Verdict::kAccepted), 20);
}

TEST(Slam, MapsALongLoopWithOurPresetAsItIs) {
  const Simulation simulation = Simulate(MakeWorld("loop"), {});
  const auto odometry =
      EvaluateTrajectory(simulation.ground_truth, OdometryTrajectoryOf(simulation.log));
  EXPECT_GT(odometry->translation.rmse, 1.0);
  const Recording recording = MapLog(simulation.log, LoopscopePreset(), 2);
  const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
  EXPECT_LT(error->translation.rmse, 0.05);
}

/// A smooth corridor of 20 m, there and back, with something to see only at its ends.
Simulation SimulateAmbiguousCorridor(double max_range, int seed, double scan_period = 0.25) {
  World world;
  world.name = "ambiguous";
  world.plan.AddRoom({0.0, 0.0}, {20.0, 2.4});
  world.plan.AddBox(Pose2(0.6, 2.0, 0.0), {1.0, 0.6});
  world.plan.AddPillar({19.0, 0.5}, 0.3);
  world.route = {{2.0, 1.2}, {17.0, 1.2}, {2.0, 1.2}};
  SimulationOptions options;
  options.seed = seed;
  options.scan_period = scan_period;
  options.lidar.beams = {181, DegreesToRadians(-90.0), DegreesToRadians(1.0)};
  options.lidar.max_range = max_range;
  return Simulate(world, options);
}

/// How far the farthest of the loops that were closed is from the truth [m].
double WorstLoop(const Recording& recording, const Trajectory& ground_truth) {
  const auto truth = [&](NodeId node) {
    return PoseAt(ground_truth, recording.log().scans[recording.node(node).step].time);
  };
  double worst = 0.0;
  for (const LoopCandidate& loop : recording.candidates()) {
    if (loop.verdict != Verdict::kAccepted) continue;
    const NodeId first = recording.submap(loop.submap).first_node;
    const Pose2 submap_from_first = SubmapFromNode(recording, loop.submap, first);
    const Pose2 expected = submap_from_first * (truth(first).Inverse() * truth(loop.node));
    worst = std::max(worst, (expected.Inverse() * loop.submap_from_node).translation.norm());
  }
  return worst;
}

/// Its seed.
class SlamInAnAmbiguousCorridor : public ::testing::TestWithParam<int> {
 protected:
  static void ExpectNoFalseLoop(double max_range, double max_error) {
    const Simulation simulation = SimulateAmbiguousCorridor(max_range, GetParam());
    const Recording recording = MapLog(simulation.log, SmallLoopOptions());
    EXPECT_GT(NumCandidates(recording, Verdict::kAmbiguous), 20);
    EXPECT_GT(NumCandidates(recording, Verdict::kAccepted), 0);
    EXPECT_LT(WorstLoop(recording, simulation.ground_truth), 0.2);
    const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
    EXPECT_LT(error->translation.rmse, max_error);
  }
};

INSTANTIATE_TEST_SUITE_P(Seeds, SlamInAnAmbiguousCorridor, ::testing::Range(1, 5));

TEST_P(SlamInAnAmbiguousCorridor, ClosesNoFalseLoopIfItSeesTheEnds) {
  ExpectNoFalseLoop(30.0, 0.05);
}

TEST_P(SlamInAnAmbiguousCorridor, ClosesNoFalseLoopIfNothingTellsHowFarItWent) {
  ExpectNoFalseLoop(8.0, 0.4);
}

TEST(Slam, DoesNotLagBehindInACorridorThatIsScannedOften) {
  for (const int seed : {1, 6}) {
    const Simulation simulation = SimulateAmbiguousCorridor(8.0, seed, 0.05);
    const Recording recording = MapLog(simulation.log, LoopscopePreset(), 2);
    const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
    EXPECT_LT(error->translation.rmse, 0.25) << seed;
  }
}

/// Maps a built-in world in which places look alike, and expects no false loop.
Recording MapPlacesThatLookAlike(const std::string& world, int seed, double max_loop_error,
                                 const Options& options = LoopscopePreset()) {
  SimulationOptions simulation_options;
  simulation_options.seed = seed;
  const Simulation simulation = Simulate(MakeWorld(world), simulation_options);
  Recording recording = MapLog(simulation.log, options, 2);
  EXPECT_GT(NumCandidates(recording, Verdict::kAccepted), 20);
  EXPECT_LT(WorstLoop(recording, simulation.ground_truth), max_loop_error);
  const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
  EXPECT_LT(error->translation.rmse, 0.05);
  return recording;
}

TEST(Slam, KeepsRoomsThatAreAllAlikeApart) { MapPlacesThatLookAlike("hotel", 2, 0.5); }

TEST(Slam, KeepsTheTwoSidesOfARackApart) {
  // Walls that are taken to go on between returns score so much that no false loop comes near them.
  Options options = LoopscopePreset();
  options.trajectory_builder_2d.submaps.range_data_inserter.max_wall_gap = 0.0;
  const Recording recording = MapPlacesThatLookAlike("warehouse", 5, 0.3, options);
  EXPECT_GT(NumCandidates(recording, Verdict::kFromBehind), 0);
}

TEST(Slam, GivesTheSameRecordingOnAnyNumberOfThreads) {
  const Simulation simulation = SimulateSmallLoop();
  const Recording one_thread = MapLog(simulation.log, SmallLoopOptions(), 1);
  ASSERT_GT(NumCandidates(one_thread, Verdict::kAccepted), 0);
  for (const int num_threads : {1, 2, 4}) {
    const Recording recording = MapLog(simulation.log, SmallLoopOptions(), num_threads);
    EXPECT_EQ(HashOfRecording(recording), HashOfRecording(one_thread)) << num_threads;
  }
}

TEST(Slam, RecordsAVerdictOnEveryPairThatItConsidered) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.sampling_ratio = 0.5;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  EXPECT_GT(NumCandidates(recording, Verdict::kAccepted), 0);
  EXPECT_GT(NumCandidates(recording, Verdict::kBelowMinScore), 0);
  EXPECT_GT(NumCandidates(recording, Verdict::kNotSampled), 0);
  EXPECT_EQ(NumCandidates(recording, Verdict::kTooFar), 0);  // these follow from the state
  for (const LoopCandidate& candidate : recording.candidates()) {
    EXPECT_LE(candidate.considered_step, candidate.applied_step);
    if (candidate.verdict == Verdict::kNotSampled) continue;
    EXPECT_EQ(candidate.score > candidate.min_score, candidate.verdict != Verdict::kBelowMinScore);
    EXPECT_GE(candidate.score_bound, candidate.score);
  }
}

TEST(Slam, OptimizesEveryNNodesAndAtTheEnd) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const int every = SmallLoopOptions().pose_graph.optimize_every_n_nodes;
  const auto& optimizations = recording.optimizations();
  ASSERT_GT(optimizations.size(), 3u);
  for (std::size_t i = 0; i + 1 < optimizations.size(); ++i) {
    EXPECT_EQ(optimizations[i].global_from_node.size(), (i + 1) * every);
    EXPECT_FALSE(optimizations[i].final);
  }
  EXPECT_TRUE(optimizations.back().final);
  EXPECT_EQ(optimizations.back().step, recording.num_steps() - 1);
  EXPECT_EQ(optimizations.back().global_from_node.size(), recording.nodes().size());
}

TEST(Slam, OptimizesAfterAShareOfAllNodesIfThatIsMore) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimize_every_share = 0.25;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  // A quarter of 32 is 8 again; from then on each must be larger by a third than the one before.
  std::vector<std::size_t> sizes;
  for (const Optimization& optimization : recording.optimizations()) {
    sizes.push_back(optimization.global_from_node.size());
  }
  ASSERT_GT(sizes.size(), 6u);
  sizes.resize(6);
  EXPECT_THAT(sizes, testing::ElementsAre(8, 16, 24, 32, 43, 58));
}

TEST(Slam, HoldsSubmap0) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  for (const Optimization& optimization : recording.optimizations()) {
    EXPECT_EQ(optimization.global_from_submap[0], recording.submaps()[0].local_from_submap);
  }
}

TEST(Slam, SearchesNoLoopsIfItNeverOptimizes) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimize_every_n_nodes = 0;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  EXPECT_TRUE(recording.candidates().empty());
  ASSERT_EQ(recording.optimizations().size(), 1u);
  EXPECT_THAT(recording.optimizations()[0].global_from_node.back(),
              PoseNear(recording.nodes().back().local_from_base, 1e-6, 1e-6));
}

ScanLog FirstScans(int num_scans) {
  ScanLog log = SimulateSmallLoop().log;
  log.scans.resize(num_scans);
  return log;
}

void Blind(LaserScan* scan) {
  for (float& range : scan->ranges) range = std::numeric_limits<float>::infinity();
}

TEST(Slam, OfAnEmptyLogIsNothing) {
  const Recording recording = MapLog(FirstScans(0), SmallLoopOptions());
  EXPECT_EQ(recording.num_steps(), 0);
  EXPECT_TRUE(recording.submaps().empty());
  EXPECT_TRUE(recording.optimizations().empty());
}

TEST(Slam, OfASingleScanIsOneNodeInOneSubmap) {
  const Recording recording = MapLog(FirstScans(1), SmallLoopOptions());
  ASSERT_EQ(recording.nodes().size(), 1u);
  ASSERT_EQ(recording.submaps().size(), 1u);
  EXPECT_EQ(recording.step(0).outcome, StepOutcome::kInserted);
  ASSERT_EQ(recording.optimizations().size(), 1u);
  EXPECT_TRUE(recording.optimizations()[0].final);
  EXPECT_EQ(StateAfterStep(recording, 0).global_from_base, Pose2());
}

TEST(Slam, OfScansWithoutReturnsFollowsOdometryAndMapsNothing) {
  ScanLog log = FirstScans(20);
  for (LaserScan& scan : log.scans) Blind(&scan);
  const Recording recording = MapLog(log, SmallLoopOptions());
  EXPECT_TRUE(recording.nodes().empty());
  EXPECT_TRUE(recording.optimizations().empty());
  EXPECT_EQ(recording.step(7).outcome, StepOutcome::kNoReturns);
  const Pose2 odometry_motion =
      OdometryOfScan(log, 0)->odom_from_base.Inverse() * OdometryOfScan(log, 19)->odom_from_base;
  EXPECT_THAT(StateAfterStep(recording, 19).global_from_base, PoseNear(odometry_motion, 2e-5, 2e-5))
      << "but for rounding at each scan";
}

TEST(Slam, BeginsWithTheFirstScanThatHasReturnsAndEndsWithOneThatHasNone) {
  ScanLog log = FirstScans(30);
  for (const int scan : {0, 1, 2, 29}) Blind(&log.scans[scan]);
  const Recording recording = MapLog(log, SmallLoopOptions());
  ASSERT_FALSE(recording.nodes().empty());
  EXPECT_EQ(recording.nodes()[0].step, 3);
  EXPECT_EQ(recording.optimizations().back().step, 29);
}

TEST(Slam, MapsWithoutOdometry) {
  SimulationOptions simulation_options;
  simulation_options.lidar.beams = {361, -M_PI, DegreesToRadians(1.0)};
  Simulation simulation = Simulate(SmallLoopWorld(), simulation_options);
  simulation.log.odometry.clear();
  for (LaserScan& scan : simulation.log.scans) scan.num_odometry_before = 0;
  const Recording recording = MapLog(simulation.log, SmallLoopOptions());
  const auto error = EvaluateTrajectory(simulation.ground_truth, TrajectoryOf(recording));
  EXPECT_LT(error->translation.rmse, 0.05);
}

}  // namespace
}  // namespace loopscope
