// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/moving_part.h"

#include <algorithm>
#include <utility>

#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"

namespace loopscope {
namespace {

/// `Term` is Constraint or ConsecutiveNodes.
template <typename Term>
double SquareOf(const Eigen::Vector3d& error, const Term& term) {
  return SpaInformation::OfWeights(term.translation_weight, term.rotation_weight).SquareOf(error);
}

/// What a term adds to the cost at the poses of `graph`.
double CostOf(const Constraint& c, const GraphState& graph,
              const OptimizationProblemOptions& options) {
  const Eigen::Vector3d error =
      SpaError(c.submap_from_node, graph.global_from_submap[c.submap.index],
               graph.global_from_node[c.node.index]);
  const double square = SquareOf(error, c);
  if (c.tag != Constraint::Tag::kInterSubmap) return 0.5 * square;
  return IsOutlier(error, options.outliers) ? 0.0 : HuberCost(square, options.huber_scale);
}

double CostOf(const ConsecutiveNodes& c, const GraphState& graph) {
  const Eigen::Vector3d error = SpaError(c.first_from_second, graph.global_from_node[c.first.index],
                                         graph.global_from_node[c.second.index]);
  return 0.5 * SquareOf(error, c);
}

}  // namespace

MovingPart::MovingPart(const GraphState& graph, const std::vector<Constraint>& constraints,
                       const std::vector<ConsecutiveNodes>& consecutive_nodes,
                       SubmapId first_moving, const OptimizationProblemOptions& options)
    : first_moving_node_(graph.submap(first_moving).first_node.index) {
  problem_.global_from_submap = graph.global_from_submap;
  problem_.num_held_submaps = std::max(first_moving.index, 1);
  for (std::size_t i = 0; i < constraints.size(); ++i) {
    const Constraint& c = constraints[i];
    if (c.submap < first_moving && c.node.index < first_moving_node_) {
      left_out_cost_ += CostOf(c, graph, options);
    } else {
      problem_.constraints.push_back(c);
      constraint_indices_.push_back(i);
    }
  }
  for (const ConsecutiveNodes& c : consecutive_nodes) {
    if (c.second.index < first_moving_node_) {
      left_out_cost_ += CostOf(c, graph);
    } else {
      problem_.consecutive_nodes.push_back(c);
    }
  }
  TakeNodes(graph.global_from_node);
}

void MovingPart::TakeNodes(const std::vector<Pose2>& global_from_node) {
  constexpr int kNone = -1;
  constexpr int kNeeded = 0;
  std::vector<int> numbers(global_from_node.size(), kNone);  // in the problem
  for (const Constraint& c : problem_.constraints) numbers[c.node.index] = kNeeded;
  for (const ConsecutiveNodes& c : problem_.consecutive_nodes) numbers[c.first.index] = kNeeded;
  int num_nodes = 0;
  for (int node = 0; node < static_cast<int>(numbers.size()); ++node) {
    if (node == first_moving_node_) problem_.num_held_nodes = num_nodes;
    if (node < first_moving_node_ && numbers[node] == kNone) continue;
    numbers[node] = num_nodes++;
    problem_.global_from_node.push_back(global_from_node[node]);
  }
  const auto number = [&](NodeId* node) { node->index = numbers[node->index]; };
  for (Constraint& c : problem_.constraints) number(&c.node);
  for (ConsecutiveNodes& c : problem_.consecutive_nodes) {
    number(&c.first);
    number(&c.second);
  }
}

std::size_t MovingPart::NumAmongFirst(std::size_t count) const {
  const auto end = std::lower_bound(constraint_indices_.begin(), constraint_indices_.end(), count);
  return static_cast<std::size_t>(end - constraint_indices_.begin());
}

GraphSolution MovingPart::Completed(GraphSolution solution, const GraphState& graph) const {
  std::vector<Pose2> global_from_node = graph.global_from_node;
  std::copy(solution.global_from_node.begin() + problem_.num_held_nodes,
            solution.global_from_node.end(), global_from_node.begin() + first_moving_node_);
  solution.global_from_node = std::move(global_from_node);
  solution.initial_cost = left_out_cost_ + solution.initial_cost;
  solution.final_cost = left_out_cost_ + solution.final_cost;
  return solution;
}

}  // namespace loopscope
