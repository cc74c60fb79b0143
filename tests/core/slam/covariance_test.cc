// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/covariance.h"

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

MapState LastState(const Recording& recording) {
  return StateAfterStep(recording, recording.num_steps() - 1);
}

TEST(GraphOf, IsAtItsMinimumAfterTheFinalOptimization) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const OptimizationProblemOptions& options = recording.options().pose_graph.optimization_problem;
  const GraphSolution again = SolveGraph(GraphOf(recording, LastState(recording)), options, {50});
  const double final_cost = recording.optimizations().back().final_cost;
  EXPECT_NEAR(again.initial_cost, final_cost, 1e-6 * final_cost);
  EXPECT_NEAR(again.final_cost, final_cost, 1e-3 * final_cost);
}

TEST(GraphOf, HasOdometryTermsOnlyIfTheyAreAskedFor) {
  Options options = SmallLoopOptions();
  const Recording without = MapLog(SimulateSmallLoop().log, options);
  options.pose_graph.optimization_problem.odometry_translation_weight = 1.0;
  const Recording with = MapLog(SimulateSmallLoop().log, options);
  EXPECT_EQ(GraphOf(without, LastState(without)).consecutive_nodes.size(),
            without.nodes().size() - 1);
  EXPECT_EQ(GraphOf(with, LastState(with)).consecutive_nodes.size(), 2 * (with.nodes().size() - 1));
}

TEST(CovarianceOfNode, IsSmallerOnceTheLoopIsClosed) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  int first_loop = -1;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (candidate.verdict != Verdict::kAccepted || candidate.submap.index > 1) continue;
    first_loop = candidate.applied_step;
    break;
  }
  ASSERT_GT(first_loop, 0);
  const MapState before = StateAfterStep(recording, first_loop - 1);
  const NodeId node{before.num_nodes - 1};
  const auto open = CovarianceOfNode(recording, before, node);
  const auto closed = CovarianceOfNode(recording, LastState(recording), node);
  ASSERT_TRUE(open && closed);
  EXPECT_LT(closed->trace(), 0.5 * open->trace());
}

TEST(CovarianceOfSubmap, IsZeroForTheFirstAndPositiveForOthers) {
  const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  const MapState state = LastState(recording);
  EXPECT_TRUE(CovarianceOfSubmap(recording, state, SubmapId{0})->isZero());
  const auto covariance = CovarianceOfSubmap(recording, state, SubmapId{3});
  ASSERT_TRUE(covariance.has_value());
  EXPECT_GT(covariance->determinant(), 0.0);
}

}  // namespace
}  // namespace loopscope
