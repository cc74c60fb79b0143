// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/map_quality.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

/// Returns of a wall along x, of a standard deviation across it.
PointCloud Wall(double deviation) {
  std::mt19937 random(1);
  std::normal_distribution<> across(0.0, deviation);
  PointCloud points;
  for (int i = 0; i < 20000; ++i) points.emplace_back(0.001 * i, across(random));
  return points;
}

TEST(Crispness, IsTheThicknessOfAWall) {
  EXPECT_NEAR(CrispnessOf(Wall(0.02)).wall_thickness, 0.02, 0.001);
  EXPECT_NEAR(CrispnessOf(Wall(0.05)).wall_thickness, 0.05, 0.002);
}

TEST(Crispness, IsTheEntropyOfANormalDistribution) {
  // Along the wall the returns are spread evenly over 0.6 m, for which the entropy takes the normal
  // distribution of the same variance.
  const double along = 0.6 / std::sqrt(12.0);
  const double expected = std::log(2.0 * M_PI * M_E * along * 0.02);
  EXPECT_NEAR(CrispnessOf(Wall(0.02)).mean_map_entropy, expected, 0.05);
}

TEST(Crispness, CountsOnlyWhatIsNearby) {
  PointCloud points;  // a cross of five returns, 0.1 m apart, and one far away
  for (const double d : {-0.1, 0.1}) {
    points.emplace_back(d, 0.0);
    points.emplace_back(0.0, d);
  }
  points.emplace_back(0.0, 0.0);
  points.emplace_back(5.0, 5.0);
  // The covariance is 0.02 / 4 in each direction.
  EXPECT_NEAR(CrispnessOf(points).wall_thickness, std::sqrt(0.005), 1e-12);
  EXPECT_NEAR(CrispnessOf(points).mean_map_entropy, std::log(2.0 * M_PI * M_E * 0.005), 1e-12);
}

TEST(Crispness, OfNothingIsZero) {
  EXPECT_EQ(CrispnessOf({}).mean_map_entropy, 0.0);
  EXPECT_EQ(CrispnessOf(PointCloud(4, {1.0, 1.0})).wall_thickness, 0.0);
  EXPECT_EQ(CrispnessOf(PointCloud(40, {1.0, 1.0})).wall_thickness, 0.0);
  EXPECT_EQ(CrispnessOf(PointCloud(40, {1.0, 1.0})).mean_map_entropy, 0.0);
}

TEST(MapQuality, SuffersFromWrongPoses) {
  const Recording& recording = SmallLoopRun();
  MapState state = LastState(recording);
  const MapQuality good = EvaluateMap(recording, state);
  EXPECT_GT(good.disagreement, 0.0);
  EXPECT_LT(good.disagreement, 0.3);
  for (int i = 0; i < state.num_nodes; i += 2) state.global_from_node[i].translation.x() += 0.15;
  const MapQuality bad = EvaluateMap(recording, state);
  EXPECT_GT(bad.disagreement, 1.2 * good.disagreement);
  EXPECT_GT(bad.crispness.wall_thickness, 1.2 * good.crispness.wall_thickness);
  EXPECT_GT(bad.crispness.mean_map_entropy, 0.1 + good.crispness.mean_map_entropy);
}

/// One scan of three beams, seen from two places.
Recording TwoScans() {
  ScanLog log;
  log.beam_geometries = {{3, -0.5, 0.5}};
  for (int i = 0; i < 2; ++i) log.scans.push_back({1.0 * i, 0, {2.0f, 2.0f, 2.0f}, 0});
  Recording recording(log, LoopscopePreset());
  for (int i = 0; i < 2; ++i) {
    SlamUpdate update;
    update.step.outcome = StepOutcome::kInserted;
    update.step.node = NodeId{i};
    if (i == 0) update.started_submap = Submap();
    update.node = Node{i, Pose2(), SubmapId{0}, 1};
    recording.Append(update);
  }
  return recording;
}

TEST(MapQuality, DisagreementIsTheShareOfMissesAmongTheObservations) {
  const Recording recording = TwoScans();
  MapState state = StateAfterStep(recording, 1);
  EXPECT_EQ(EvaluateMap(recording, state).disagreement, 0.0);
  // The second scan sees its returns behind those of the first, and goes straight through the
  // middle one of them. Hits weigh more than misses, so that it stays occupied: 6 hits, 1 miss.
  state.global_from_node[1] = Pose2(0.5, 0.0, 0.0);
  EXPECT_NEAR(EvaluateMap(recording, state).disagreement, 1.0 / 7.0, 1e-12);
}

}  // namespace
}  // namespace loopscope
