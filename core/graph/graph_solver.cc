// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/graph_solver.h"

#include <cassert>
#include <utility>

#include <ceres/covariance.h>
#include <ceres/loss_function.h>
#include <ceres/problem.h>
#include <ceres/solver.h>

#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

using PoseBlock = Eigen::Vector3d;  ///< x, y, theta

std::vector<PoseBlock> ToBlocks(const std::vector<Pose2>& poses) {
  std::vector<PoseBlock> blocks;
  blocks.reserve(poses.size());
  for (const Pose2& pose : poses) blocks.emplace_back(pose.x(), pose.y(), pose.rotation);
  return blocks;
}

std::vector<Pose2> ToPoses(const std::vector<PoseBlock>& blocks) {
  std::vector<Pose2> poses;
  poses.reserve(blocks.size());
  for (const PoseBlock& block : blocks) {
    poses.emplace_back(block.x(), block.y(), NormalizeAngle(block.z()));
  }
  return poses;
}

/// A GraphProblem as Ceres wants it.
class CeresGraph {
 public:
  CeresGraph(const GraphProblem& graph, const OptimizationProblemOptions& options)
      : submaps_(ToBlocks(graph.global_from_submap)), nodes_(ToBlocks(graph.global_from_node)) {
    for (const Constraint& c : graph.constraints) {
      ceres::LossFunction* loss = c.tag == Constraint::Tag::kInterSubmap
                                      ? new ceres::HuberLoss(options.huber_scale)
                                      : nullptr;
      problem_.AddResidualBlock(
          MakeSpaCost(c.submap_from_node, c.translation_weight, c.rotation_weight).release(), loss,
          submap_block(c.submap), node_block(c.node));
    }
    for (const ConsecutiveNodes& c : graph.consecutive_nodes) {
      problem_.AddResidualBlock(
          MakeSpaCost(c.first_from_second, c.translation_weight, c.rotation_weight).release(),
          nullptr, node_block(c.first), node_block(c.second));
    }
    problem_.SetParameterBlockConstant(submap_block(SubmapId{0}));
  }

  ceres::Problem& problem() { return problem_; }
  double* submap_block(SubmapId id) { return submaps_[id.index].data(); }
  double* node_block(NodeId id) { return nodes_[id.index].data(); }
  std::vector<Pose2> submap_poses() const { return ToPoses(submaps_); }
  std::vector<Pose2> node_poses() const { return ToPoses(nodes_); }

 private:
  std::vector<PoseBlock> submaps_;
  std::vector<PoseBlock> nodes_;
  ceres::Problem problem_;
};

std::optional<Eigen::Matrix3d> CovarianceOfBlock(CeresGraph* graph, double* block) {
  ceres::Covariance::Options options;
  options.algorithm_type = ceres::SPARSE_QR;
  options.num_threads = 1;
  ceres::Covariance covariance(options);
  const std::vector<std::pair<const double*, const double*>> wanted{{block, block}};
  if (!covariance.Compute(wanted, &graph->problem())) return std::nullopt;
  Eigen::Matrix<double, 3, 3, Eigen::RowMajor> matrix;
  covariance.GetCovarianceBlock(block, block, matrix.data());
  return matrix;
}

}  // namespace

GraphSolution SolveGraph(const GraphProblem& problem, const OptimizationProblemOptions& options,
                         int max_num_iterations) {
  assert(!problem.global_from_submap.empty());
  CeresGraph graph(problem, options);
  ceres::Solver::Options solver_options;
  solver_options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver_options.sparse_linear_algebra_library_type = ceres::SUITE_SPARSE;
  solver_options.use_nonmonotonic_steps = options.use_nonmonotonic_steps;
  solver_options.max_num_iterations = max_num_iterations;
  solver_options.num_threads = 1;
  solver_options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options, &graph.problem(), &summary);
  return {graph.submap_poses(), graph.node_poses(), static_cast<int>(summary.iterations.size()),
          summary.initial_cost, summary.final_cost};
}

std::optional<Eigen::Matrix3d> CovarianceOfNode(const GraphProblem& problem,
                                                const OptimizationProblemOptions& options,
                                                NodeId node) {
  CeresGraph graph(problem, options);
  return CovarianceOfBlock(&graph, graph.node_block(node));
}

std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const GraphProblem& problem,
                                                  const OptimizationProblemOptions& options,
                                                  SubmapId submap) {
  if (submap.index == 0) return Eigen::Matrix3d(Eigen::Matrix3d::Zero());
  CeresGraph graph(problem, options);
  return CovarianceOfBlock(&graph, graph.submap_block(submap));
}

}  // namespace loopscope
