// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/loop_closures.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/line_run.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

constexpr LoopTolerance kTolerance{0.5, 0.1};

TEST(LoopClosures, AreComparedWithTheNearestNodeOfTheSubmap) {
  // Local SLAM is right but for node 3, which the true robot reached 0.3 m later. A loop in submap
  // 0 is right where it is compared with node 1, and wrong by the same where with node 3.
  Trajectory reference = LineReference();
  reference[3].map_from_base.translation +=
      reference[3].map_from_base.RotationMatrix().col(0) * 0.3;
  const Recording recording = LineRun({LineLoop(0, 22, {}), LineLoop(0, 20, {})});
  const auto loops =
      JudgeLoops(recording, LastState(recording), ReferencePosesOfNodes(recording, reference));
  ASSERT_EQ(loops.size(), 2u);
  EXPECT_NEAR(loops[0].error->translation.norm(), 0.0, 1e-12);
  EXPECT_NEAR(loops[1].error->translation.norm(), 0.3, 1e-12);
}

TEST(LoopClosures, HaveTheErrorThatTheyWereMadeWith) {
  const Recording recording = LineRun({LineLoop(1, 17, Pose2(0.3, -0.4, 0.2))});
  const auto loops = JudgeLoops(recording, LastState(recording),
                                ReferencePosesOfNodes(recording, LineReference()));
  EXPECT_NEAR(loops[0].error->x(), 0.3, 1e-12);
  EXPECT_NEAR(loops[0].error->y(), -0.4, 1e-12);
  EXPECT_NEAR(loops[0].error->rotation, 0.2, 1e-12);
  EXPECT_NEAR(loops[0].residual.head<2>().norm(), 0.5, 1e-12);
}

TEST(LoopClosures, AreWeighedAsHubersLossDoes) {
  Options options = LoopscopePreset();
  options.pose_graph.constraint_builder.loop_closure_translation_weight = 100.0;
  options.pose_graph.constraint_builder.loop_closure_rotation_weight = 10.0;
  options.pose_graph.optimization_problem.huber_scale = 5.0;
  options.pose_graph.optimization_problem.outliers.max_distance = 0.0;
  const Recording recording = LineRun({LineLoop(0, 22, Pose2(0.03, 0.0, 0.4)),   // |r| = 5
                                       LineLoop(0, 22, Pose2(0.06, 0.0, 0.8)),   // |r| = 10
                                       LineLoop(0, 22, Pose2(0.12, 0.0, 1.6))},  // |r| = 20
                                      options);
  const auto loops = JudgeLoops(recording, LastState(recording), {});
  EXPECT_NEAR(loops[0].weight, 1.0, 1e-9);
  EXPECT_NEAR(loops[1].weight, 0.5, 1e-9);
  EXPECT_NEAR(loops[2].weight, 0.25, 1e-9);
  EXPECT_FALSE(loops[2].IsInForce());
}

TEST(LoopClosures, AreInForceUnlessTheyAreOutliers) {
  Options options = LoopscopePreset();
  options.pose_graph.optimization_problem.outliers = {0.3, 0.05};
  const Recording recording =
      LineRun({LineLoop(0, 22, Pose2(0.29, 0.0, 0.0)), LineLoop(0, 22, Pose2(0.31, 0.0, 0.0)),
               LineLoop(0, 22, Pose2(0.0, 0.0, 0.049)), LineLoop(0, 22, Pose2(0.0, 0.0, 0.051))},
              options);
  const auto loops = JudgeLoops(recording, LastState(recording), {});
  EXPECT_TRUE(loops[0].IsInForce());
  EXPECT_GT(loops[0].weight, 0.0);
  EXPECT_FALSE(loops[1].IsInForce());
  EXPECT_EQ(loops[1].weight, 0.0);
  EXPECT_TRUE(loops[2].IsInForce());
  EXPECT_FALSE(loops[3].IsInForce());
}

TEST(LoopClosures, AreCountedByWhatTheyAre) {
  Options options = LoopscopePreset();
  options.pose_graph.optimization_problem.outliers.max_distance = 18.0;
  const Recording recording =
      LineRun({LineLoop(0, 22, {}), LineLoop(1, 17, Pose2(0.19, 0.0, 0.017)),
               LineLoop(1, 17, Pose2(0.21, 0.0, 0.0)), LineLoop(1, 17, Pose2(0.0, 0.0, 0.018)),
               LineLoop(2, 15, Pose2(0.6, 0.0, 0.0)), LineLoop(2, 15, Pose2(30.0, 0.0, 0.0))},
              options);
  const MapState state = LastState(recording);
  const auto reference = ReferencePosesOfNodes(recording, LineReference());
  const LoopCounts counts = CountLoops(JudgeLoops(recording, state, reference), kTolerance);
  EXPECT_EQ(counts.all, 6);
  EXPECT_EQ(counts.self_consistent, 2);
  EXPECT_EQ(counts.in_force, 5);
  EXPECT_EQ(counts.judged, 5);
  EXPECT_EQ(counts.correct, 4);
  EXPECT_EQ(CountLoops(JudgeLoops(recording, state, {}), kTolerance).judged, 0);
}

TEST(LoopClosures, AreNotJudgedOutsideOfTheReference) {
  Trajectory reference = LineReference();
  reference.resize(22);  // ends at node 21
  const Recording recording = LineRun({LineLoop(0, 22, {}), LineLoop(0, 21, {})});
  const auto loops =
      JudgeLoops(recording, LastState(recording), ReferencePosesOfNodes(recording, reference));
  EXPECT_FALSE(loops[0].error);
  EXPECT_TRUE(loops[1].error);
}

TEST(LoopClosures, OfASimulatedRunAreTrue) {
  const Recording& recording = SmallLoopRun();
  const auto reference = ReferencePosesOfNodes(recording, SimulateSmallLoop().ground_truth);
  const auto loops = JudgeLoops(recording, LastState(recording), reference);
  const LoopCounts counts = CountLoops(loops, {0.2, 0.03});
  EXPECT_GT(counts.judged, 10);
  EXPECT_GE(counts.correct, counts.judged - 1);
  EXPECT_GE(CountLoops(loops, {0.05, 0.03}).correct, counts.judged - 2);
}

}  // namespace
}  // namespace loopscope
