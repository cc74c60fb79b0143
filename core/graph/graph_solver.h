// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/graph/consecutive_nodes.h"
#include "core/graph/constraint.h"
#include "core/graph/pose_graph_options.h"

namespace loopscope {

/// The sum of eq. 4: submap poses, node poses and what is known about them. The poses are where the
/// search starts; the first ones stay where they are.
struct GraphProblem {
  std::vector<Pose2> global_from_submap;
  std::vector<Pose2> global_from_node;
  std::vector<Constraint> constraints;
  std::vector<ConsecutiveNodes> consecutive_nodes;
  int num_held_submaps = 1;  ///< at least 1
  int num_held_nodes = 0;
};

struct GraphSolution {
  std::vector<Pose2> global_from_submap;
  std::vector<Pose2> global_from_node;
  int num_iterations = 0;
  double initial_cost = 0.0;
  double final_cost = 0.0;
};

/// When an optimization ends.
struct SolverLimits {
  int max_num_iterations = 50;
  double function_tolerance = 1e-6;  ///< share of the cost that the last iteration may have gained
};

/// `next`, which began where `first` ended, with the iterations of both.
GraphSolution Continued(const GraphSolution& first, GraphSolution next);

/// Half of eq. 4 at the poses of `problem`, as SolveGraph has it.
double CostOf(const GraphProblem& problem, const OptimizationProblemOptions& options);

/// (SPA): minimizes eq. 4 by Levenberg-Marquardt, with Huber loss on INTER_SUBMAP constraints;
/// Konolige et al., "Efficient Sparse Pose Adjustment for 2D Mapping", IROS 2010. One thread: sums
/// keep their order.
GraphSolution SolveGraph(const GraphProblem& problem, const OptimizationProblemOptions& options,
                         const SolverLimits& limits);

/// Covariance [m, m, rad] of the pose of a node in the global frame, at the poses of `problem`.
/// Nothing if the problem does not determine the pose; zero if it is held.
std::optional<Eigen::Matrix3d> CovarianceOfNode(const GraphProblem& problem,
                                                const OptimizationProblemOptions& options,
                                                NodeId node);
/// Likewise of a submap.
std::optional<Eigen::Matrix3d> CovarianceOfSubmap(const GraphProblem& problem,
                                                  const OptimizationProblemOptions& options,
                                                  SubmapId submap);

}  // namespace loopscope
