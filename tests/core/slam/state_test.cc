// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/state.h"

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

using ::testing::Not;

/// The recording of a run of the small loop, and the updates that it was made of.
struct MappedRun {
  Recording recording;
  std::vector<SlamUpdate> updates;
};

MappedRun MakeRun() {
  MappedRun run{Recording(SimulateSmallLoop().log, SmallLoopOptions()), {}};
  Slam slam(run.recording.log(), run.recording.options(), 1);
  for (int scan = 0; scan < static_cast<int>(run.recording.log().scans.size()); ++scan) {
    run.updates.push_back(slam.AddScan(scan));
    run.recording.Append(run.updates.back());
  }
  return run;
}

Recording CutAfter(const MappedRun& run, int step) {
  Recording recording(run.recording.log(), run.recording.options());
  for (int i = 0; i <= step; ++i) recording.Append(run.updates[i]);
  return recording;
}

void ExpectEqual(const MapState& a, const MapState& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.num_nodes, b.num_nodes);
  EXPECT_EQ(a.num_submaps, b.num_submaps);
  EXPECT_EQ(a.num_candidates, b.num_candidates);
  EXPECT_EQ(a.num_optimizations, b.num_optimizations);
  EXPECT_EQ(a.global_from_local, b.global_from_local);
  EXPECT_EQ(a.global_from_base, b.global_from_base);
  EXPECT_EQ(a.global_from_submap, b.global_from_submap);
  EXPECT_EQ(a.global_from_node, b.global_from_node);
}

TEST(StateAfterStep, IsTheLastStateOfARunThatWasInterruptedThere) {
  const MappedRun run = MakeRun();
  for (int step = 0; step < run.recording.num_steps(); ++step) {
    SCOPED_TRACE(step);
    const Recording cut = CutAfter(run, step);
    ASSERT_EQ(cut.num_steps(), step + 1);
    ExpectEqual(StateAfterStep(run.recording, step), StateAfterStep(cut, step));
  }
}

TEST(StateAfterStep, HoldsWhatHadComeAboutUntilThen) {
  const MappedRun run = MakeRun();
  int num_nodes = 0;
  int num_submaps = 0;
  int num_candidates = 0;
  int num_optimizations = 0;
  for (int step = 0; step < run.recording.num_steps(); ++step) {
    SCOPED_TRACE(step);
    const SlamUpdate& update = run.updates[step];
    num_nodes += update.node ? 1 : 0;
    num_submaps += update.started_submap ? 1 : 0;
    num_candidates += static_cast<int>(update.candidates.size());
    num_optimizations += update.optimization ? 1 : 0;
    const MapState state = StateAfterStep(run.recording, step);
    EXPECT_EQ(state.num_nodes, num_nodes);
    EXPECT_EQ(state.num_submaps, num_submaps);
    EXPECT_EQ(state.num_candidates, num_candidates);
    EXPECT_EQ(state.num_optimizations, num_optimizations);
    EXPECT_EQ(state.global_from_node.size(), static_cast<std::size_t>(num_nodes));
    EXPECT_EQ(state.global_from_submap.size(), static_cast<std::size_t>(num_submaps));
  }
}

TEST(StateAfterStep, HasThePosesOfTheFinalOptimizationAtTheEnd) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  ASSERT_TRUE(recording.optimizations().back().final);
  EXPECT_EQ(state.global_from_node, recording.optimizations().back().global_from_node);
  EXPECT_EQ(state.global_from_submap, recording.optimizations().back().global_from_submap);
}

TEST(StateAfterStep, IsTheLocalFrameBeforeAnyOptimization) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const int step = recording.optimizations()[0].step - 1;
  const MapState state = StateAfterStep(recording, step);
  EXPECT_EQ(state.num_optimizations, 0);
  EXPECT_THAT(state.global_from_base, PoseNear(recording.step(step).local_from_base, 1e-12, 1e-12));
}

TEST(StateAfterStep, CarriesNewNodesWithTheSubmapThatWasNewestAtTheOptimization) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const Optimization& optimization = recording.optimizations()[10];
  const std::size_t newest = optimization.global_from_submap.size() - 1;
  const Pose2 global_from_local = optimization.global_from_submap[newest] *
                                  recording.submaps()[newest].local_from_submap.Inverse();
  const MapState state = StateAfterStep(recording, recording.optimizations()[11].step - 1);
  ASSERT_GT(state.global_from_node.size(), optimization.global_from_node.size());
  EXPECT_THAT(global_from_local, Not(PoseNear(Pose2(), 1e-3, 1e-3)));
  for (std::size_t i = optimization.global_from_node.size(); i < state.global_from_node.size();
       ++i) {
    EXPECT_THAT(state.global_from_node[i],
                PoseNear(global_from_local * recording.nodes()[i].local_from_base, 1e-12, 1e-12));
  }
}

TEST(StateBeforeOptimization, HoldsTheNodeOfTheStepButNotWhatTheOptimizationBrought) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const int step = recording.optimizations()[11].step;
  const MapState before = StateBeforeOptimization(recording, step);
  const MapState after = StateAfterStep(recording, step);
  EXPECT_EQ(before.num_nodes, after.num_nodes);
  EXPECT_EQ(before.num_submaps, after.num_submaps);
  EXPECT_EQ(before.num_optimizations, 11);
  EXPECT_EQ(after.num_optimizations, 12);
  EXPECT_LT(before.num_candidates, after.num_candidates);
  EXPECT_EQ(before.global_from_local, StateAfterStep(recording, step - 1).global_from_local);
  EXPECT_EQ(before.global_from_node.back(),
            before.global_from_local * recording.nodes()[before.num_nodes - 1].local_from_base);
}

TEST(StateBeforeOptimization, IsTheStateAfterAStepThatSetOffNone) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const int step = recording.optimizations()[11].step - 1;
  ExpectEqual(StateBeforeOptimization(recording, step), StateAfterStep(recording, step));
}

TEST(GlobalFromBase, IsThePoseOfTheNodeWhereAScanBecameOne) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  for (std::size_t i = 0; i < recording.nodes().size(); ++i) {
    EXPECT_THAT(GlobalFromBase(recording, state, recording.nodes()[i].step),
                PoseNear(state.global_from_node[i], 1e-12, 1e-12));
  }
}

TEST(GlobalFromBase, FollowsLocalSlamFromTheNodeBefore) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  int num_filtered = 0;
  int node = -1;
  for (int step = 0; step < recording.num_steps(); ++step) {
    if (recording.step(step).outcome == StepOutcome::kInserted) ++node;
    if (recording.step(step).outcome != StepOutcome::kMotionFiltered) continue;
    ++num_filtered;
    const Pose2 node_from_base =
        recording.nodes()[node].local_from_base.Inverse() * recording.step(step).local_from_base;
    EXPECT_THAT(GlobalFromBase(recording, state, step),
                PoseNear(state.global_from_node[node] * node_from_base, 1e-12, 1e-12));
  }
  EXPECT_GT(num_filtered, 10);
}

}  // namespace
}  // namespace loopscope
