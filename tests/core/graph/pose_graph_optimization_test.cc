// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// When the pose graph is optimized, and what becomes of it.
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/core/graph/return_to_a_room.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

/// At how many nodes the first optimizations are due, up to 16.
std::vector<int> WhenOptimizationsAreDue(const PoseGraphOptions& options) {
  PoseGraph graph(options, 1);
  graph.AddSubmap(Pose2());
  std::vector<int> due;
  for (int i = 1; i <= 16; ++i) {
    graph.AddNode({Pose2(i, 0.0, 0.0), std::nullopt, SubmapId{0}, 1, ScanOf({})}, i);
    if (!graph.OptimizationIsDue()) continue;
    graph.Optimize();
    due.push_back(i);
  }
  return due;
}

TEST(PoseGraphOptimization, IsDueAfterAShareOfTheNodesButNotTooSeldom) {
  PoseGraphOptions options = Options();
  options.optimize_every_n_nodes = 2;
  EXPECT_THAT(WhenOptimizationsAreDue(options), testing::ElementsAre(2, 4, 6, 8, 10, 12, 14, 16));
  options.optimize_every_share = 0.5;
  EXPECT_THAT(WhenOptimizationsAreDue(options), testing::ElementsAre(2, 4, 8, 16));
  options.optimize_at_latest_after_n_nodes = 3;
  EXPECT_THAT(WhenOptimizationsAreDue(options), testing::ElementsAre(2, 4, 7, 10, 13, 16));
}

/// Where optimizations of a single iteration leave the first node that came back to the room, when
/// a long way was added to it, when one more node was, and in the end. None but the last gets to
/// the end by itself.
std::vector<Pose2> PosesOfANodeThatGotOld(int min_num_held_nodes) {
  PoseGraphOptions options = Options();
  options.min_num_held_nodes = min_num_held_nodes;
  options.optimization_problem.max_num_iterations = 1;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  const auto add_submap = [&](int submap) {
    const Pose2 local_from_node(10.0 * submap, 0.0, 0.0);
    run.graph().AddSubmap(local_from_node);
    run.AddNode(local_from_node, {}, submap);
  };
  for (int submap = 2; submap < 30; ++submap) add_submap(submap);
  std::vector<Pose2> poses;
  run.graph().CollectLoops(kStep);
  poses.push_back(run.graph().Optimize().global_from_node[1]);
  add_submap(30);
  run.graph().CollectLoops(kStep + 1);
  poses.push_back(run.graph().Optimize().global_from_node[1]);
  poses.push_back(run.graph().OptimizeFully().global_from_node[1]);
  return poses;
}

TEST(PoseGraphOptimization, HoldsWhatIsOldUntilTheEndIfItIsMuch) {
  const std::vector<Pose2> held = PosesOfANodeThatGotOld(2);
  EXPECT_EQ(held[1], held[0]);
  EXPECT_NE(held[2], held[0]);
  for (const int min_num_held_nodes : {0, 50}) {
    const std::vector<Pose2> moved = PosesOfANodeThatGotOld(min_num_held_nodes);
    EXPECT_NE(moved[1], moved[0]) << min_num_held_nodes;
    EXPECT_THAT(moved[2], PoseNear(held[2], 1e-3, 1e-3)) << min_num_held_nodes;
  }
}

TEST(PoseGraphOptimization, PullsTheMapTogetherWhereALoopIsClosed) {
  ReturnToARoom run(Options());
  run.ComeTo(kFirst);
  run.graph().CollectLoops(kStep);
  const GraphSolution solution = run.graph().Optimize();
  EXPECT_EQ(solution.global_from_submap[0], Pose2());
  EXPECT_THAT(solution.global_from_node[1], PoseNear(kFirst, 0.02, 0.01));
  EXPECT_THAT(solution.global_from_submap[1], PoseNear(Pose2(2.0, 0.8, 0.0), 0.05, 0.02));
}

TEST(PoseGraphOptimization, LeavesOutOnTheWayALoopThatLocalSlamAndOtherLoopsContradict) {
  PoseGraphOptions options = Options();
  options.optimization_problem.local_slam_pose_translation_weight = 1e4;
  options.optimization_problem.local_slam_pose_rotation_weight = 1e4;
  options.optimization_problem.huber_scale = 1e6;  // all pull with all their weight
  const auto place_of_false_loop = [&](double max_distance) {
    options.optimization_problem.outliers.max_distance = max_distance;
    ReturnToARoom run(options);
    for (int i = 0; i < 6; ++i) run.ComeTo(kFirst);
    run.graph().CollectLoops(kStep);
    run.graph().Optimize();
    run.AddNode(kDrift * kSecond, SimulatedRoom().ScanAt(kSecond * Pose2(0.0, 0.5, 0.0)), 1);
    for (int i = 0; i < 3; ++i) run.ComeTo(kSecond);
    run.graph().CollectLoops(kStep);
    return run.graph().Optimize().global_from_node[7];
  };
  EXPECT_THAT(place_of_false_loop(0.2), PoseNear(kSecond, 0.02, 0.01));
  EXPECT_THAT(place_of_false_loop(0.0), ::testing::Not(PoseNear(kSecond, 0.05, 0.02))) << "off";
}

TEST(PoseGraphOptimization, StaysAsLocalSlamHasItWithoutLoops) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.0;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  run.graph().CollectLoops(kStep);
  EXPECT_THAT(run.graph().Optimize().global_from_node[1], PoseNear(kDrift * kFirst, 1e-6, 1e-6));
}

TEST(PoseGraphOptimization, IsDueEveryNNodes) {
  PoseGraphOptions options = Options();
  options.optimize_every_n_nodes = 2;
  ReturnToARoom run(options);
  EXPECT_FALSE(run.graph().OptimizationIsDue());
  run.ComeTo(kFirst);
  EXPECT_TRUE(run.graph().OptimizationIsDue());
  run.graph().CollectLoops(kStep);
  run.graph().Optimize();
  EXPECT_FALSE(run.graph().OptimizationIsDue());
}

}  // namespace
}  // namespace loopscope
