// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_consistency.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

namespace loopscope {

bool Agree(const LoopDrift& a, const LoopDrift& b, const LoopConsistencyOptions& options) {
  const double node_way = std::abs(a.node_way - b.node_way);
  const double submap_way = std::abs(a.submap_way - b.submap_way);
  if (node_way > options.max_way || submap_way > options.max_way) return false;
  const Pose2 difference = (a.drift * a.local_from_node).Inverse() * (b.drift * a.local_from_node);
  return std::abs(difference.rotation) <= options.max_angle &&
         difference.translation.norm() <=
             options.max_distance + options.max_distance_per_meter * (node_way + submap_way);
}

void LoopDrifts::AddNear(const LoopDrift& loop, double max_way,
                         std::vector<LoopDrift>* near) const {
  const auto end = by_node_way_.upper_bound(loop.node_way + max_way);
  for (auto i = by_node_way_.lower_bound(loop.node_way - max_way); i != end; ++i) {
    near->push_back(i->second);
  }
}

int NumSupporters(const LoopDrift& loop, const std::vector<LoopDrift>& others,
                  const LoopConsistencyOptions& options) {
  std::map<int, double> way_of_node;
  for (const LoopDrift& other : others) {
    if (other.node == loop.node || !Agree(loop, other, options)) continue;
    way_of_node.emplace(other.node.index, other.node_way);
  }
  int num_supporters = 0;
  double last_way = -std::numeric_limits<double>::infinity();
  for (const auto& [node, way] : way_of_node) {
    if (std::abs(way - loop.node_way) < options.min_way || way - last_way < options.min_way)
      continue;
    last_way = way;
    ++num_supporters;
  }
  return num_supporters;
}

int MinNumSupporters(const LoopCandidate& loop, const LoopConsistencyOptions& options) {
  const bool is_good =
      options.good_score_ratio > 0.0 && loop.score >= options.good_score_ratio * loop.min_score;
  return is_good ? std::max(options.min_num_supporters - 1, 0) : options.min_num_supporters;
}

std::vector<NodeId> NeighborsToCheck(NodeId node, const std::vector<NodeId>& left_out,
                                     const std::vector<double>& node_ways,
                                     const LoopConsistencyOptions& options) {
  const auto way_between = [&](NodeId a, NodeId b) {
    return std::abs(node_ways[a.index] - node_ways[b.index]);
  };
  std::vector<NodeId> nearest_first = left_out;
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [&](NodeId a, NodeId b) { return way_between(a, node) < way_between(b, node); });
  std::vector<NodeId> chosen;
  for (const NodeId neighbor : nearest_first) {
    if (static_cast<int>(chosen.size()) >= options.num_checked_neighbors) break;
    if (way_between(neighbor, node) > options.max_way) break;
    const auto is_too_near = [&](NodeId other) {
      return way_between(neighbor, other) < options.min_way;
    };
    if (is_too_near(node) || std::any_of(chosen.begin(), chosen.end(), is_too_near)) continue;
    chosen.push_back(neighbor);
  }
  return chosen;
}

}  // namespace loopscope
