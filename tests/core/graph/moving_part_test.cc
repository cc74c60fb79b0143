// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/moving_part.h"

#include <gtest/gtest.h>

#include "core/graph/outliers.h"
#include "core/simulation/random.h"

namespace loopscope {
namespace {

constexpr int kNumSubmaps = 8;
constexpr int kNodesPerSubmap = 5;
constexpr SubmapId kFirstMoving{5};

/// A way with a submap every few nodes, none of whose measurements agree with each other.
class NoisyWay {
 public:
  NoisyWay() {
    for (int i = 0; i < kNumSubmaps * kNodesPerSubmap; ++i) {
      const Pose2 pose(0.5 * i, 0.1 * i, 0.02 * i);
      if (i % kNodesPerSubmap == 0) {
        graph.submaps.push_back({pose, NodeId{i}, kNodesPerSubmap, {}, 0.0, 0.0, {}});
        graph.global_from_submap.push_back(pose);
      }
      graph.nodes.push_back({pose, std::nullopt, SubmapId{i / kNodesPerSubmap}, 1, nullptr, false});
      graph.global_from_node.push_back(pose);
      AddConstraint(i / kNodesPerSubmap, i, Constraint::Tag::kIntraSubmap);
      if (i == 0) continue;
      consecutive_nodes.push_back(
          {NodeId{i - 1}, NodeId{i},
           Noisy(graph.global_from_node[i - 1].Inverse() * graph.global_from_node[i]), 30.0, 90.0});
    }
    options.huber_scale = 1.0;
    options.outliers = {2.0, 0.5};
  }

  void AddConstraint(int submap, int node, Constraint::Tag tag, const Pose2& error = {}) {
    const Pose2 submap_from_node =
        graph.global_from_submap[submap].Inverse() * graph.global_from_node[node];
    constraints.push_back(
        {SubmapId{submap}, NodeId{node}, Noisy(submap_from_node) * error, 50.0, 160.0, tag});
  }

  /// With all terms and nodes.
  GraphSolution SolveWhole(SubmapId first_moving) const {
    GraphProblem problem{graph.global_from_submap, graph.global_from_node, constraints,
                         consecutive_nodes};
    problem.num_held_submaps = first_moving.index;
    problem.num_held_nodes = graph.submap(first_moving).first_node.index;
    return SolveGraph(WithoutOutliers(problem, options.outliers), options, {50});
  }

  MovingPart Part(SubmapId first_moving) const {
    return MovingPart(graph, constraints, consecutive_nodes, first_moving, options);
  }

  GraphState graph;
  std::vector<Constraint> constraints;
  std::vector<ConsecutiveNodes> consecutive_nodes;
  OptimizationProblemOptions options;

 private:
  Pose2 Noisy(const Pose2& pose) {
    return pose * Pose2(random_.Uniform(-0.1, 0.1), random_.Uniform(-0.1, 0.1),
                        random_.Uniform(-0.05, 0.05));
  }

  Random random_{7};
};

void ExpectSame(const GraphSolution& a, const GraphSolution& b) {
  EXPECT_EQ(a.global_from_submap, b.global_from_submap);
  EXPECT_EQ(a.global_from_node, b.global_from_node);
  EXPECT_EQ(a.num_iterations, b.num_iterations);
  EXPECT_NEAR(a.initial_cost, b.initial_cost, 1e-12 * b.initial_cost);
  EXPECT_NEAR(a.final_cost, b.final_cost, 1e-12 * b.final_cost);
}

TEST(MovingPart, HasTheSolutionOfTheWhole) {
  NoisyWay way;
  way.AddConstraint(1, 33, Constraint::Tag::kInterSubmap);  // from a held submap to what moves
  way.AddConstraint(6, 12, Constraint::Tag::kInterSubmap);  // from what moves to a held node
  way.AddConstraint(0, 17, Constraint::Tag::kInterSubmap);  // between what is held
  way.AddConstraint(2, 21, Constraint::Tag::kInterSubmap, Pose2(0.4, 0.0, 0.0));  // likewise
  const MovingPart part = way.Part(kFirstMoving);
  EXPECT_EQ(part.problem().num_held_nodes, 2);  // 12, and the one before the first that moves
  EXPECT_EQ(part.problem().global_from_node.size(), 2u + 3 * kNodesPerSubmap);
  const GraphSolution solution = SolveGraph(part.problem(), way.options, {50});
  EXPECT_GT(solution.num_iterations, 1);
  ExpectSame(part.Completed(solution, way.graph), way.SolveWhole(kFirstMoving));
}

TEST(MovingPart, CountsNoOutliersOfWhatIsHeld) {
  NoisyWay way;
  way.AddConstraint(0, 17, Constraint::Tag::kInterSubmap, Pose2(5.0, 0.0, 0.0));
  const MovingPart part = way.Part(kFirstMoving);
  const GraphSolution solution = SolveGraph(part.problem(), way.options, {50});
  ExpectSame(part.Completed(solution, way.graph), way.SolveWhole(kFirstMoving));
}

TEST(MovingPart, IsTheWholeButForSubmap0IfNothingIsHeld) {
  const NoisyWay way;
  const MovingPart part = way.Part(SubmapId{0});
  EXPECT_EQ(part.problem().num_held_submaps, 1);
  EXPECT_EQ(part.problem().num_held_nodes, 0);
  EXPECT_EQ(part.problem().constraints.size(), way.constraints.size());
  EXPECT_EQ(part.problem().consecutive_nodes.size(), way.consecutive_nodes.size());
  EXPECT_EQ(part.problem().global_from_node, way.graph.global_from_node);
}

TEST(MovingPart, KnowsWhichConstraintsCameFirst) {
  NoisyWay way;
  way.AddConstraint(0, 17, Constraint::Tag::kInterSubmap);  // left out
  way.AddConstraint(1, 33, Constraint::Tag::kInterSubmap);
  const MovingPart part = way.Part(kFirstMoving);
  ASSERT_EQ(part.problem().constraints.size(), 3u * kNodesPerSubmap + 1);
  EXPECT_EQ(part.NumAmongFirst(25), 0u);
  EXPECT_EQ(part.NumAmongFirst(27), 2u);
  EXPECT_EQ(part.NumAmongFirst(41), 15u);
  EXPECT_EQ(part.NumAmongFirst(42), 16u);
}

}  // namespace
}  // namespace loopscope
