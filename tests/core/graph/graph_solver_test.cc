// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/graph_solver.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "core/graph/spa_cost.h"
#include "core/simulation/random.h"
#include "tests/support/ceres_graph.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

using ::testing::Not;

constexpr int kNumSubmaps = 3;
constexpr int kNodesPerSubmap = 6;

/// A robot that goes a circle, with a submap every few nodes, as things truly are.
struct TrueGraph {
  std::vector<Pose2> global_from_submap;
  std::vector<Pose2> global_from_node;
};

TrueGraph MakeTrueGraph() {
  TrueGraph graph;
  Pose2 global_from_base(1.0, 2.0, 0.5);
  for (int i = 0; i < kNumSubmaps * kNodesPerSubmap; ++i) {
    if (i % kNodesPerSubmap == 0) graph.global_from_submap.push_back(global_from_base);
    graph.global_from_node.push_back(global_from_base);
    global_from_base = global_from_base * Pose2(0.8, 0.02, 0.35);
  }
  return graph;
}

Constraint TrueConstraint(const TrueGraph& graph, int submap, int node, Constraint::Tag tag) {
  return {SubmapId{submap},
          NodeId{node},
          graph.global_from_submap[submap].Inverse() * graph.global_from_node[node],
          500.0,
          1600.0,
          tag};
}

/// All that is known is true: each submap holds its own nodes and those of the one before, the last
/// nodes were found in the first submap. The poses where the search starts are not true, but for
/// submap 0.
GraphProblem MakeProblem(const TrueGraph& graph) {
  GraphProblem problem;
  Random random(3);
  const auto disturbed = [&](const Pose2& pose) {
    return pose *
           Pose2(random.Uniform(-0.4, 0.4), random.Uniform(-0.4, 0.4), random.Uniform(-0.3, 0.3));
  };
  for (const Pose2& pose : graph.global_from_submap) {
    problem.global_from_submap.push_back(problem.global_from_submap.empty() ? pose
                                                                            : disturbed(pose));
  }
  const int num_nodes = static_cast<int>(graph.global_from_node.size());
  for (int node = 0; node < num_nodes; ++node) {
    problem.global_from_node.push_back(disturbed(graph.global_from_node[node]));
    const int newest = node / kNodesPerSubmap;
    for (int submap = std::max(0, newest - 1); submap <= newest; ++submap) {
      problem.constraints.push_back(
          TrueConstraint(graph, submap, node, Constraint::Tag::kIntraSubmap));
    }
    if (node == 0) continue;
    problem.consecutive_nodes.push_back(
        {NodeId{node - 1}, NodeId{node},
         graph.global_from_node[node - 1].Inverse() * graph.global_from_node[node], 300.0, 900.0});
  }
  for (int node = num_nodes - 3; node < num_nodes; ++node) {
    problem.constraints.push_back(TrueConstraint(graph, 0, node, Constraint::Tag::kInterSubmap));
  }
  return problem;
}

void ExpectTruth(const GraphSolution& solution, const TrueGraph& graph, double meters,
                 double radians) {
  ASSERT_EQ(solution.global_from_submap.size(), graph.global_from_submap.size());
  ASSERT_EQ(solution.global_from_node.size(), graph.global_from_node.size());
  for (std::size_t i = 0; i < graph.global_from_submap.size(); ++i) {
    EXPECT_THAT(solution.global_from_submap[i],
                PoseNear(graph.global_from_submap[i], meters, radians));
  }
  for (std::size_t i = 0; i < graph.global_from_node.size(); ++i) {
    EXPECT_THAT(solution.global_from_node[i], PoseNear(graph.global_from_node[i], meters, radians));
  }
}

TEST(SolveGraph, FindsTheTruthFromWrongPoses) {
  const TrueGraph graph = MakeTrueGraph();
  const GraphSolution solution = SolveGraph(MakeProblem(graph), {}, {50});
  ExpectTruth(solution, graph, 1e-6, 1e-6);
  EXPECT_GT(solution.initial_cost, 1.0);
  EXPECT_LT(solution.final_cost, 1e-8);
  EXPECT_GT(solution.num_iterations, 1);
}

TEST(SolveGraph, LeavesSubmap0WhereItIs) {
  GraphProblem problem = MakeProblem(MakeTrueGraph());
  const Pose2 moved = Pose2(-4.0, 3.0, 2.0) * problem.global_from_submap[0];
  problem.global_from_submap[0] = moved;
  EXPECT_EQ(SolveGraph(problem, {}, {50}).global_from_submap[0], moved);
}

TEST(SolveGraph, MovesAllWithSubmap0) {
  TrueGraph graph = MakeTrueGraph();
  GraphProblem problem = MakeProblem(graph);
  const Pose2 motion(-0.5, 0.3, 0.4);
  problem.global_from_submap[0] = motion * problem.global_from_submap[0];
  for (Pose2& pose : graph.global_from_submap) pose = motion * pose;
  for (Pose2& pose : graph.global_from_node) pose = motion * pose;
  ExpectTruth(SolveGraph(problem, {}, {50}), graph, 1e-6, 1e-6);
}

TEST(SolveGraph, StopsAfterTheIterationsAllowed) {
  const GraphProblem problem = MakeProblem(MakeTrueGraph());
  EXPECT_EQ(SolveGraph(problem, {}, {0}).global_from_node[5], problem.global_from_node[5]);
  EXPECT_GT(SolveGraph(problem, {}, {1}).final_cost, SolveGraph(problem, {}, {50}).final_cost);
}

TEST(SolveGraph, StopsWhenAnIterationGainsTooLittle) {
  const GraphProblem problem = MakeProblem(MakeTrueGraph());
  EXPECT_EQ(SolveGraph(problem, {}, {50, 1.0}).num_iterations, 1);
  EXPECT_GT(SolveGraph(problem, {}, {50, 0.5}).num_iterations, 1);
}

TEST(SolveGraph, GivesTheSameBitsAgain) {
  const GraphProblem problem = MakeProblem(MakeTrueGraph());
  const GraphSolution first = SolveGraph(problem, {}, {50});
  const GraphSolution second = SolveGraph(problem, {}, {50});
  EXPECT_EQ(first.global_from_submap, second.global_from_submap);
  EXPECT_EQ(first.global_from_node, second.global_from_node);
}

/// A loop that is wrong by 3 m and 60 degrees.
Constraint Outlier(const TrueGraph& graph, Constraint::Tag tag) {
  Constraint outlier = TrueConstraint(graph, 0, 10, tag);
  outlier.submap_from_node = outlier.submap_from_node * Pose2(3.0, 0.0, DegreesToRadians(60.0));
  return outlier;
}

TEST(SolveGraph, HardlyYieldsToAFalseLoop) {
  const TrueGraph graph = MakeTrueGraph();
  GraphProblem problem = MakeProblem(graph);
  problem.constraints.push_back(Outlier(graph, Constraint::Tag::kInterSubmap));
  OptimizationProblemOptions options;
  options.huber_scale = 1.0;
  ExpectTruth(SolveGraph(problem, options, {200}), graph, 0.01, 0.01);
}

TEST(SolveGraph, YieldsToAFalseConstraintThatIsNoLoop) {
  const TrueGraph graph = MakeTrueGraph();
  GraphProblem problem = MakeProblem(graph);
  problem.constraints.push_back(Outlier(graph, Constraint::Tag::kIntraSubmap));
  OptimizationProblemOptions options;
  options.huber_scale = 1.0;
  EXPECT_THAT(SolveGraph(problem, options, {200}).global_from_node[10],
              Not(PoseNear(graph.global_from_node[10], 0.2, 0.05)));
}

/// As MakeProblem, but as disturbed as a robot has it: noise on all that is known, loops that are
/// false, and nodes without terms to nodes, if `with_consecutive` is not set.
GraphProblem MakeNoisyProblem(int seed, bool with_consecutive) {
  const TrueGraph graph = MakeTrueGraph();
  GraphProblem problem = MakeProblem(graph);
  Random random(seed);
  for (Constraint& c : problem.constraints) {
    c.submap_from_node = c.submap_from_node *
                         Pose2(random.Gaussian(0.02), random.Gaussian(0.02), random.Gaussian(0.01));
  }
  problem.constraints.push_back(Outlier(graph, Constraint::Tag::kInterSubmap));
  if (!with_consecutive) problem.consecutive_nodes.clear();
  return problem;
}

TEST(SolveGraph, ReachesTheCostThatCeresReaches) {
  OptimizationProblemOptions options;
  options.huber_scale = 20.0;
  for (int seed = 0; seed < 10; ++seed) {
    for (const bool with_consecutive : {true, false}) {
      SCOPED_TRACE(seed);
      const GraphProblem problem = MakeNoisyProblem(seed, with_consecutive);
      const GraphSolution ours = SolveGraph(problem, options, {200});
      const GraphSolution theirs = SolveGraphWithCeres(problem, options, 200);
      EXPECT_NEAR(ours.initial_cost, theirs.initial_cost, 1e-9 * theirs.initial_cost);
      EXPECT_NEAR(ours.final_cost, theirs.final_cost, 1e-5 * theirs.final_cost);
      for (std::size_t i = 0; i < problem.global_from_node.size(); ++i) {
        EXPECT_THAT(ours.global_from_node[i], PoseNear(theirs.global_from_node[i], 2e-3, 2e-3));
      }
    }
  }
}

TEST(SolveGraph, ReachesTheCostThatCeresReachesWhereOldPosesAreHeld) {
  for (int seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    GraphProblem problem = MakeNoisyProblem(seed, true);
    problem.num_held_submaps = 1 + seed % 2;
    problem.num_held_nodes = kNodesPerSubmap + seed;
    const GraphSolution ours = SolveGraph(problem, {}, {200});
    const GraphSolution theirs = SolveGraphWithCeres(problem, {}, 200);
    EXPECT_NEAR(ours.initial_cost, theirs.initial_cost, 1e-9 * theirs.initial_cost);
    EXPECT_NEAR(ours.final_cost, theirs.final_cost, 1e-5 * theirs.final_cost);
    for (int i = 0; i < problem.num_held_submaps; ++i) {
      EXPECT_EQ(ours.global_from_submap[i], problem.global_from_submap[i]) << i;
    }
    for (int i = 0; i < problem.num_held_nodes; ++i) {
      EXPECT_EQ(ours.global_from_node[i], problem.global_from_node[i]) << i;
    }
    for (std::size_t i = problem.num_held_nodes; i < problem.global_from_node.size(); ++i) {
      EXPECT_THAT(ours.global_from_node[i], PoseNear(theirs.global_from_node[i], 2e-3, 2e-3));
    }
  }
}

/// The residuals of a problem without Huber loss at poses moved by `delta`: three numbers for each
/// submap but the first, then for each node.
Eigen::VectorXd ResidualsAt(const GraphProblem& problem, const Eigen::VectorXd& delta) {
  const auto moved = [&](const Pose2& pose, int block) {
    if (block < 0) return pose;
    return Pose2(pose.x() + delta[3 * block], pose.y() + delta[3 * block + 1],
                 pose.rotation + delta[3 * block + 2]);
  };
  const auto submap = [&](SubmapId id) {
    return moved(problem.global_from_submap[id.index], id.index - 1);
  };
  const int num_submaps = static_cast<int>(problem.global_from_submap.size());
  const auto node = [&](NodeId id) {
    return moved(problem.global_from_node[id.index], num_submaps - 1 + id.index);
  };
  std::vector<double> residuals;
  const auto add = [&](const Eigen::Vector3d& error, double translation, double rotation) {
    residuals.insert(residuals.end(),
                     {translation * error.x(), translation * error.y(), rotation * error.z()});
  };
  for (const Constraint& c : problem.constraints) {
    add(SpaError(c.submap_from_node, submap(c.submap), node(c.node)), c.translation_weight,
        c.rotation_weight);
  }
  for (const ConsecutiveNodes& c : problem.consecutive_nodes) {
    add(SpaError(c.first_from_second, node(c.first), node(c.second)), c.translation_weight,
        c.rotation_weight);
  }
  return Eigen::Map<Eigen::VectorXd>(residuals.data(), residuals.size());
}

/// The inverse of the normal equations J^T J, with J by differences.
Eigen::MatrixXd DenseCovariance(const GraphProblem& problem) {
  constexpr double kStep = 1e-6;
  const int size =
      3 * static_cast<int>(problem.global_from_submap.size() - 1 + problem.global_from_node.size());
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(size);
  Eigen::MatrixXd jacobian(ResidualsAt(problem, zero).size(), size);
  for (int i = 0; i < size; ++i) {
    const Eigen::VectorXd step = kStep * Eigen::VectorXd::Unit(size, i);
    jacobian.col(i) = (ResidualsAt(problem, step) - ResidualsAt(problem, -step)) / (2.0 * kStep);
  }
  return (jacobian.transpose() * jacobian).inverse();
}

/// The problem at its solution, where loops are within the part of Huber's loss that is a square.
GraphProblem SolvedProblem() {
  GraphProblem problem = MakeProblem(MakeTrueGraph());
  const GraphSolution solution = SolveGraph(problem, {}, {100});
  problem.global_from_submap = solution.global_from_submap;
  problem.global_from_node = solution.global_from_node;
  return problem;
}

TEST(Covariance, IsTheInverseOfTheNormalEquations) {
  const GraphProblem problem = SolvedProblem();
  const Eigen::MatrixXd dense = DenseCovariance(problem);
  for (const int node : {0, 7, 17}) {
    const int at = 3 * (kNumSubmaps - 1 + node);
    const Eigen::Matrix3d expected = dense.block<3, 3>(at, at);
    const auto covariance = CovarianceOfNode(problem, {}, NodeId{node});
    ASSERT_TRUE(covariance);
    EXPECT_LT((*covariance - expected).norm(), 1e-5 * expected.norm()) << node;
  }
  for (int submap = 1; submap < kNumSubmaps; ++submap) {
    const int at = 3 * (submap - 1);
    const Eigen::Matrix3d expected = dense.block<3, 3>(at, at);
    const auto covariance = CovarianceOfSubmap(problem, {}, SubmapId{submap});
    ASSERT_TRUE(covariance);
    EXPECT_LT((*covariance - expected).norm(), 1e-5 * expected.norm()) << submap;
  }
}

TEST(Covariance, OfWhatIsHeldIsZero) {
  GraphProblem problem = SolvedProblem();
  EXPECT_EQ(*CovarianceOfSubmap(problem, {}, SubmapId{0}), Eigen::Matrix3d::Zero());
  problem.num_held_nodes = 3;
  EXPECT_EQ(*CovarianceOfNode(problem, {}, NodeId{2}), Eigen::Matrix3d::Zero());
  EXPECT_GT(CovarianceOfNode(problem, {}, NodeId{3})->trace(), 0.0);
}

TEST(Covariance, ShrinksWithALoop) {
  const GraphProblem with_loop = SolvedProblem();
  GraphProblem without = with_loop;
  without.constraints.erase(
      std::remove_if(without.constraints.begin(), without.constraints.end(),
                     [](const Constraint& c) { return c.tag == Constraint::Tag::kInterSubmap; }),
      without.constraints.end());
  const NodeId last{kNumSubmaps * kNodesPerSubmap - 1};
  EXPECT_LT(CovarianceOfNode(with_loop, {}, last)->trace(),
            0.8 * CovarianceOfNode(without, {}, last)->trace());
}

TEST(Covariance, IsNothingIfNothingHoldsThePose) {
  GraphProblem problem = SolvedProblem();
  problem.global_from_node.emplace_back();
  problem.global_from_node.emplace_back();
  const NodeId first{static_cast<int>(problem.global_from_node.size()) - 2};
  const NodeId second{first.index + 1};
  problem.consecutive_nodes.push_back({first, second, Pose2(), 100.0, 100.0});
  EXPECT_FALSE(CovarianceOfNode(problem, {}, second));
}

}  // namespace
}  // namespace loopscope
