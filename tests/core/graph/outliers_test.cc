// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/outliers.h"

#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr int kNumNodes = 30;

Pose2 TruePose(int node) { return Pose2(0.5 * node, 0.0, 0.0); }

/// A robot on a straight way with one submap and local SLAM that drifts a little, and loops that
/// tell where every third node truly is.
GraphProblem DriftingWay() {
  GraphProblem problem;
  problem.global_from_submap = {Pose2()};
  const Pose2 measured(0.5, 0.01, 0.0);
  for (int i = 0; i < kNumNodes; ++i) {
    problem.global_from_node.push_back(i == 0 ? Pose2()
                                              : problem.global_from_node.back() * measured);
    if (i > 0) {
      problem.consecutive_nodes.push_back({NodeId{i - 1}, NodeId{i}, measured, 300.0, 300.0});
    }
  }
  problem.constraints = {{SubmapId{0}, NodeId{0}, Pose2(), 1e4, 1e4}};
  for (int node = 2; node < kNumNodes; node += 3) {
    problem.constraints.push_back(
        {SubmapId{0}, NodeId{node}, TruePose(node), 1e3, 1e3, Constraint::Tag::kInterSubmap});
  }
  return problem;
}

Constraint FalseLoop(int node, const Pose2& error, Constraint::Tag tag) {
  return {SubmapId{0}, NodeId{node}, TruePose(node) * error, 1e3, 1e3, tag};
}

OptimizationProblemOptions Options() {
  OptimizationProblemOptions options;
  options.outliers = {0.3, 0.1};
  return options;
}

TEST(IsOutlier, IsWhatIsTooFarOrTurnedTooMuch) {
  const OutlierOptions options{0.3, 0.1};
  EXPECT_FALSE(IsOutlier({0.2, -0.2, -0.09}, options));
  EXPECT_TRUE(IsOutlier({0.22, -0.22, 0.0}, options));
  EXPECT_TRUE(IsOutlier({0.0, 0.0, -0.11}, options));
  EXPECT_FALSE(IsOutlier({9.0, 9.0, 3.0}, OutlierOptions())) << "off";
}

TEST(SolveGraphWithoutOutliers, IsTheSolutionIfThereAreNone) {
  const GraphSolution with = SolveGraph(DriftingWay(), Options(), {50});
  const GraphSolution without = SolveGraphWithoutOutliers(DriftingWay(), 0, Options(), {50}, 10);
  EXPECT_EQ(with.global_from_node, without.global_from_node);
  EXPECT_EQ(with.num_iterations, without.num_iterations);
}

TEST(SolveGraphWithoutOutliers, ForgetsFalseLoops) {
  const GraphSolution expected = SolveGraph(DriftingWay(), Options(), {50});
  for (const Pose2& error : {Pose2(0.0, 1.5, 0.0), Pose2(0.0, 0.0, 0.5)}) {
    GraphProblem problem = DriftingWay();
    problem.constraints.push_back(FalseLoop(10, error, Constraint::Tag::kInterSubmap));
    const GraphSolution solution = SolveGraphWithoutOutliers(problem, 0, Options(), {50}, 10);
    EXPECT_THAT(SolveGraph(problem, Options(), {50}).global_from_node[10],
                ::testing::Not(PoseNear(expected.global_from_node[10], 0.01, 0.01)));
    EXPECT_THAT(solution.global_from_node[10], PoseNear(expected.global_from_node[10], 1e-3, 1e-3));
    EXPECT_NEAR(solution.final_cost, expected.final_cost, 0.01 * expected.final_cost);
    EXPECT_NEAR(solution.initial_cost, expected.initial_cost, 1e-9 * expected.initial_cost)
        << "of the same loops";
  }
}

/// A false loop, and poses that put its node where it says.
GraphProblem BentByAFalseLoop() {
  GraphProblem problem = DriftingWay();
  const Pose2 error(0.0, 1.5, 0.0);
  problem.constraints.push_back(FalseLoop(11, error, Constraint::Tag::kInterSubmap));
  problem.global_from_node[11] = TruePose(11) * error;
  return problem;
}

TEST(SolveGraphWithoutOutliers, TakesBackALoopThatTheOthersAgreeWith) {
  GraphProblem problem = DriftingWay();
  problem.global_from_node[11] = TruePose(11) * Pose2(0.0, 1.5, 0.0);
  const GraphSolution expected = SolveGraph(DriftingWay(), Options(), {50});
  const std::size_t all = problem.constraints.size();
  ASSERT_LT(WithoutOutliers(problem, Options().outliers).constraints.size(), all);
  const GraphSolution solution = SolveGraphWithoutOutliers(problem, all, Options(), {50}, 10);
  EXPECT_THAT(solution.global_from_node[11], PoseNear(expected.global_from_node[11], 1e-3, 1e-3));
  EXPECT_NEAR(solution.final_cost, expected.final_cost, 1e-3 * expected.final_cost);
}

TEST(SolveGraphWithoutOutliers, DoesNotTryThoseAgainThatWereLeftOut) {
  const GraphProblem known = [] {
    GraphProblem problem = BentByAFalseLoop();
    const GraphSolution before = SolveGraph(DriftingWay(), Options(), {50});
    problem.global_from_node = before.global_from_node;
    return problem;
  }();
  const std::size_t all = known.constraints.size();
  const int tried_again = SolveGraphWithoutOutliers(known, 0, Options(), {50}, 10).num_iterations;
  const int left_out = SolveGraphWithoutOutliers(known, all, Options(), {50}, 10).num_iterations;
  EXPECT_LT(left_out, tried_again);
  EXPECT_LE(left_out, 2);
}

TEST(SolveGraphWithoutOutliers, JudgesNewLoopsByTheSolutionAndNotByThePosesBefore) {
  const GraphProblem problem = BentByAFalseLoop();
  const std::size_t all = problem.constraints.size();
  const GraphSolution expected = SolveGraph(DriftingWay(), Options(), {50});
  const GraphSolution solution = SolveGraphWithoutOutliers(problem, all - 1, Options(), {50}, 10);
  EXPECT_THAT(solution.global_from_node[11], PoseNear(expected.global_from_node[11], 1e-3, 1e-3));
}

TEST(SolveGraphWithoutOutliers, SolvesNoOftenerThanAllowed) {
  GraphProblem problem = DriftingWay();
  problem.constraints.push_back(FalseLoop(10, Pose2(0.0, 1.5, 0.0), Constraint::Tag::kInterSubmap));
  const SolverLimits limits{50};
  const GraphSolution bent = SolveGraph(problem, Options(), limits);
  const GraphSolution unjudged = SolveGraphWithoutOutliers(problem, 0, Options(), limits, 0);
  const GraphSolution judged = SolveGraphWithoutOutliers(problem, 0, Options(), limits, 1);
  EXPECT_EQ(unjudged.global_from_node, bent.global_from_node);
  EXPECT_GT(judged.num_iterations, bent.num_iterations);
  EXPECT_LT(judged.final_cost, bent.final_cost);
}

TEST(WithoutOutliers, GoesByThePosesOfTheProblem) {
  const GraphProblem problem = DriftingWay();  // local SLAM drifts by 1 cm a node to the side
  EXPECT_EQ(WithoutOutliers(problem, {0.4, 0.1}).constraints.size(), 11u);
  EXPECT_EQ(WithoutOutliers(problem, {0.215, 0.1}).constraints.size(), 8u);
  EXPECT_EQ(WithoutOutliers(problem, {0.01, 0.1}).constraints.size(), 1u);
}

TEST(WithoutOutliers, TakesNothingButLoopsForFalse) {
  GraphProblem problem = DriftingWay();
  problem.constraints = {FalseLoop(10, Pose2(0.0, 1.5, 0.0), Constraint::Tag::kIntraSubmap)};
  EXPECT_EQ(WithoutOutliers(problem, {0.1, 0.1}).constraints.size(), 1u);
}

}  // namespace
}  // namespace loopscope
