// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/ceres_graph.h"

#include <ceres/ceres.h>

namespace loopscope {
namespace {

/// Eq. 5, weighted.
struct Error {
  template <typename T>
  bool operator()(const T* i, const T* j, T* residuals) const {
    const T dx = j[0] - i[0];
    const T dy = j[1] - i[1];
    residuals[0] = translation_weight * (measured.x() - (cos(i[2]) * dx + sin(i[2]) * dy));
    residuals[1] = translation_weight * (measured.y() - (cos(i[2]) * dy - sin(i[2]) * dx));
    const T turn = measured.rotation - (j[2] - i[2]);
    residuals[2] = rotation_weight * (turn - 2.0 * M_PI * floor((turn + M_PI) / (2.0 * M_PI)));
    return true;
  }
  Pose2 measured;
  double translation_weight;
  double rotation_weight;
};

using Block = Eigen::Vector3d;  ///< x, y, theta

std::vector<Block> ToBlocks(const std::vector<Pose2>& poses) {
  std::vector<Block> blocks;
  for (const Pose2& pose : poses) blocks.emplace_back(pose.x(), pose.y(), pose.rotation);
  return blocks;
}

std::vector<Pose2> ToPoses(const std::vector<Block>& blocks) {
  std::vector<Pose2> poses;
  for (const Block& b : blocks) poses.emplace_back(b.x(), b.y(), NormalizeAngle(b.z()));
  return poses;
}

}  // namespace

GraphSolution SolveGraphWithCeres(const GraphProblem& graph,
                                  const OptimizationProblemOptions& options,
                                  int max_num_iterations) {
  std::vector<Block> submaps = ToBlocks(graph.global_from_submap);
  std::vector<Block> nodes = ToBlocks(graph.global_from_node);
  ceres::Problem problem;
  const auto add = [&](const Error& error, ceres::LossFunction* loss, Block* i, Block* j) {
    problem.AddResidualBlock(new ceres::AutoDiffCostFunction<Error, 3, 3, 3>(new Error(error)),
                             loss, i->data(), j->data());
  };
  for (const Constraint& c : graph.constraints) {
    add({c.submap_from_node, c.translation_weight, c.rotation_weight},
        c.tag == Constraint::Tag::kInterSubmap ? new ceres::HuberLoss(options.huber_scale)
                                               : nullptr,
        &submaps[c.submap.index], &nodes[c.node.index]);
  }
  for (const ConsecutiveNodes& c : graph.consecutive_nodes) {
    add({c.first_from_second, c.translation_weight, c.rotation_weight}, nullptr,
        &nodes[c.first.index], &nodes[c.second.index]);
  }
  const auto hold = [&](Block* block) {
    if (problem.HasParameterBlock(block->data())) problem.SetParameterBlockConstant(block->data());
  };
  for (int i = 0; i < graph.num_held_submaps; ++i) hold(&submaps[i]);
  for (int i = 0; i < graph.num_held_nodes; ++i) hold(&nodes[i]);
  ceres::Solver::Options solver_options;
  solver_options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  solver_options.max_num_iterations = max_num_iterations;
  solver_options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(solver_options, &problem, &summary);
  return {ToPoses(submaps), ToPoses(nodes), static_cast<int>(summary.iterations.size()),
          summary.initial_cost, summary.final_cost};
}

}  // namespace loopscope
