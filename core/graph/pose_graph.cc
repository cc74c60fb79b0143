// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/pose_graph.h"

#include <utility>

namespace loopscope {

Pose2 GlobalFromLocal(const std::vector<Pose2>& optimized_global_from_submap,
                      const std::vector<Pose2>& local_from_submap) {
  if (optimized_global_from_submap.empty()) return Pose2();
  const std::size_t last = optimized_global_from_submap.size() - 1;
  return optimized_global_from_submap[last] * local_from_submap[last].Inverse();
}

PoseGraph::PoseGraph(const PoseGraphOptions& options, int num_threads)
    : options_(options), loop_search_(options.constraint_builder, num_threads) {}

void PoseGraph::AddSubmap(const Pose2& local_from_submap) {
  local_from_submap_.push_back(local_from_submap);
  global_from_submap_.push_back(global_from_local_ * local_from_submap);
}

void PoseGraph::AddNode(const NodeData& node, int step) {
  const NodeId id{static_cast<int>(nodes_.size())};
  nodes_.push_back(node);
  global_from_node_.push_back(global_from_local_ * node.local_from_node);
  for (int i = 0; i < node.num_submaps; ++i) {
    const SubmapId submap{node.first_submap.index + i};
    constraints_.push_back({submap, id,
                            local_from_submap_[submap.index].Inverse() * node.local_from_node,
                            options_.matcher_translation_weight, options_.matcher_rotation_weight,
                            Constraint::Tag::kIntraSubmap});
  }
  AddConsecutive(id);
  ++num_nodes_since_optimization_;
  for (const SubmapId submap : finished_submaps_) Consider(submap, id, step);
}

void PoseGraph::AddConsecutive(NodeId id) {
  if (id.index == 0) return;
  const NodeId before{id.index - 1};
  const NodeData& first = nodes_[before.index];
  const NodeData& second = nodes_[id.index];
  const OptimizationProblemOptions& weights = options_.optimization_problem;
  const auto add = [&](const Pose2& first_from_second, double translation, double rotation) {
    if (translation == 0.0 && rotation == 0.0) return;
    consecutive_nodes_.push_back({before, id, first_from_second, translation, rotation});
  };
  add(first.local_from_node.Inverse() * second.local_from_node,
      weights.local_slam_pose_translation_weight, weights.local_slam_pose_rotation_weight);
  if (first.odom_from_node && second.odom_from_node) {
    add(first.odom_from_node->Inverse() * *second.odom_from_node,
        weights.odometry_translation_weight, weights.odometry_rotation_weight);
  }
}

void PoseGraph::FinishSubmap(SubmapId id, ProbabilityGrid grid, int step) {
  loop_search_.AddSubmap(id, std::move(grid));
  finished_submaps_.push_back(id);
  for (int i = 0; i < static_cast<int>(nodes_.size()); ++i) Consider(id, NodeId{i}, step);
}

void PoseGraph::Consider(SubmapId submap, NodeId node, int step) {
  const NodeData& data = nodes_[node.index];
  const bool lies_in_it = data.first_submap.index <= submap.index &&
                          submap.index < data.first_submap.index + data.num_submaps;
  if (lies_in_it || options_.optimize_every_n_nodes == 0) return;
  const Pose2 guess = global_from_submap_[submap.index].Inverse() * global_from_node_[node.index];
  if (guess.translation.norm() > options_.constraint_builder.max_constraint_distance) return;
  LoopCandidate candidate;
  candidate.submap = submap;
  candidate.node = node;
  candidate.considered_step = step;
  candidate.submap_from_node_guess = guess;
  loop_search_.Consider(candidate, data.points);
}

bool PoseGraph::OptimizationIsDue() const {
  return options_.optimize_every_n_nodes > 0 &&
         num_nodes_since_optimization_ >= options_.optimize_every_n_nodes;
}

std::vector<LoopCandidate> PoseGraph::CollectLoops(int step) {
  std::vector<LoopCandidate> candidates = loop_search_.Collect();
  for (LoopCandidate& candidate : candidates) {
    candidate.applied_step = step;
    if (candidate.verdict == Verdict::kAccepted) {
      constraints_.push_back(ToConstraint(candidate, options_.constraint_builder));
    }
  }
  return candidates;
}

GraphSolution PoseGraph::Optimize(int max_num_iterations) {
  GraphSolution solution =
      SolveGraph({global_from_submap_, global_from_node_, constraints_, consecutive_nodes_},
                 options_.optimization_problem, max_num_iterations);
  global_from_submap_ = solution.global_from_submap;
  global_from_node_ = solution.global_from_node;
  global_from_local_ = GlobalFromLocal(global_from_submap_, local_from_submap_);
  num_nodes_since_optimization_ = 0;
  return solution;
}

}  // namespace loopscope
