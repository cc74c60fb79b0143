// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/loop_evaluation.h"

#include <gtest/gtest.h>

#include "tests/support/line_run.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

constexpr LoopTolerance kTolerance{0.1, 0.1};

LoopEvaluation EvaluateLine(const std::vector<LoopCandidate>& loops, const Trajectory& reference) {
  Options options = LoopscopePreset();
  options.pose_graph.optimization_problem.outliers = {0.4, 0.1};
  const Recording recording = LineRun(loops, options);
  return EvaluateLoops(recording, LastState(recording), ReferencePosesOfNodes(recording, reference),
                       kTolerance);
}

/// The way of LineRun as it would be if the robot had been 0.3 m farther at `node`.
Trajectory LineReferenceWithout(int node) {
  Trajectory reference = LineReference();
  Pose2& pose = reference[node].map_from_base;
  pose = pose * Pose2(0.3, 0.0, 0.0);
  return reference;
}

TEST(LoopEvaluation, HasAFalseLoopFitWhereTheReferenceHasIt) {
  const auto evaluation = EvaluateLine({LineLoop(1, 17, Pose2(0.3, 0.0, 0.0))}, LineReference());
  ASSERT_EQ(evaluation.false_loops.size(), 1u);
  const FalseLoop& loop = evaluation.false_loops.front();
  EXPECT_EQ(loop.loop.node.index, 17);
  EXPECT_GT(loop.score_in_reference, loop.score + 0.1);
  EXPECT_TRUE(loop.FitsBetterInReference());
}

TEST(LoopEvaluation, TellsThatAReferenceIsWrong) {
  const auto evaluation = EvaluateLine({LineLoop(1, 17, {})}, LineReferenceWithout(17));
  ASSERT_EQ(evaluation.false_loops.size(), 1u);
  const FalseLoop& loop = evaluation.false_loops.front();
  EXPECT_GT(loop.score, loop.score_in_reference + 0.1);
  EXPECT_FALSE(loop.FitsBetterInReference());
}

TEST(LoopEvaluation, MissesRevisitsThatOnlyAFalseLoopTies) {
  const auto with_true = EvaluateLine({LineLoop(0, 22, {})}, LineReference());
  EXPECT_EQ(with_true.num_revisits, 1);
  EXPECT_TRUE(with_true.missed.empty());
  EXPECT_EQ(with_true.num_never_accepted, 0);
  const auto with_false = EvaluateLine({LineLoop(0, 22, Pose2(0.3, 0.0, 0.0))}, LineReference());
  EXPECT_EQ(with_false.missed.size(), 1u);
  EXPECT_EQ(with_false.num_never_accepted, 1);
}

TEST(LoopEvaluation, MissesRevisitsWhoseLoopsWereLeftOut) {
  // The reference agrees with the loop; the map does not.
  const Pose2 moved(0.5, 0.0, 0.0);
  Trajectory reference = LineReference();
  for (int i = 20; i < 24; ++i) reference[i].map_from_base = reference[i].map_from_base * moved;
  const auto evaluation = EvaluateLine({LineLoop(0, 22, moved)}, reference);
  EXPECT_TRUE(evaluation.false_loops.empty());
  EXPECT_EQ(evaluation.missed.size(), 1u);
  EXPECT_EQ(evaluation.num_never_accepted, 0);
}

TEST(LoopEvaluation, KnowsNeitherFalseLoopsNorRevisitsWithoutAReference) {
  const Recording& recording = SmallLoopRun();
  const auto evaluation = EvaluateLoops(recording, LastState(recording), {}, kTolerance);
  EXPECT_GT(evaluation.counts.all, 0);
  EXPECT_EQ(evaluation.counts.judged, 0);
  EXPECT_TRUE(evaluation.false_loops.empty());
  EXPECT_EQ(evaluation.num_revisits, 0);
}

}  // namespace
}  // namespace loopscope
