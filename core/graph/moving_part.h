// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/graph/graph_solver.h"
#include "core/graph/graph_state.h"

namespace loopscope {

/// A problem that holds all submaps before some submap, and their nodes, without the terms that
/// cannot change and the nodes that only these have: what takes long does not grow with what is
/// held.
class MovingPart {
 public:
  /// `first_moving` and all that is newer moves; but submap 0 never does. Of the terms that are
  /// left out, loops that are outliers count nothing.
  MovingPart(const GraphState& graph, const std::vector<Constraint>& constraints,
             const std::vector<ConsecutiveNodes>& consecutive_nodes, SubmapId first_moving,
             const OptimizationProblemOptions& options);

  const GraphProblem& problem() const { return problem_; }

  /// How many constraints of the problem are among the first `count` of all.
  std::size_t NumAmongFirst(std::size_t count) const;

  /// The solution of the problem with the poses of all nodes of `graph`, and the cost of all terms.
  GraphSolution Completed(GraphSolution solution, const GraphState& graph) const;

 private:
  /// Numbers the nodes of the terms as in the problem, and gives these their poses.
  void TakeNodes(const std::vector<Pose2>& global_from_node);

  GraphProblem problem_;
  std::vector<std::size_t> constraint_indices_;  ///< among all, of those of the problem
  int first_moving_node_ = 0;
  double left_out_cost_ = 0.0;
};

}  // namespace loopscope
