// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/second_look.h"

namespace loopscope {
namespace {

/// The nodes of `other` that are near the nodes of `submap`, but far from them along the way.
std::vector<NodeId> NearNodes(const SubmapPlace& submap, const SubmapPlace& other,
                              const std::vector<Pose2>& global_from_node,
                              const std::vector<double>& node_ways,
                              const SecondLookOptions& options) {
  const double first_way = node_ways[submap.first_node.index];
  const double last_way = node_ways[submap.first_node.index + submap.num_nodes - 1];
  const Pose2 submap_from_global = submap.global_from_submap.Inverse();
  std::vector<NodeId> nodes;
  for (int i = 0; i < other.num_nodes; ++i) {
    const NodeId node{other.first_node.index + i};
    const double way = node_ways[node.index];
    if (way > first_way - options.min_way && way < last_way + options.min_way) continue;
    const Eigen::Vector2d place = submap_from_global * global_from_node[node.index].translation;
    if (submap.node_box.exteriorDistance(place) <= options.max_distance) nodes.push_back(node);
  }
  return nodes;
}

Pose2 FirstFromSecond(const SubmapPlace& first, const SubmapPlace& second) {
  return first.global_from_submap.Inverse() * second.global_from_submap;
}

/// `count` of `nodes` at most, as far from each other as can be.
std::vector<NodeId> Spread(const std::vector<NodeId>& nodes, int count) {
  const int size = static_cast<int>(nodes.size());
  if (size <= count) return nodes;
  std::vector<NodeId> some;
  for (int i = 0; i < count; ++i) some.push_back(nodes[(2 * i + 1) * size / (2 * count)]);
  return some;
}

}  // namespace

std::vector<SecondLook::Pair> SecondLook::Choose(const std::vector<SubmapPlace>& submaps,
                                                 const std::vector<Pose2>& global_from_node,
                                                 const std::vector<double>& node_ways) {
  std::vector<Pair> pairs;
  if (options_.num_nodes == 0) return pairs;
  for (std::size_t b = 0; b < submaps.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      const SubmapPlace& first = submaps[a];
      const SubmapPlace& second = submaps[b];
      if (!IsDue(first, second)) continue;
      const auto in_first = NearNodes(first, second, global_from_node, node_ways, options_);
      const auto in_second = NearNodes(second, first, global_from_node, node_ways, options_);
      if (in_first.empty() && in_second.empty()) continue;
      looked_at_[{first.id, second.id}] = FirstFromSecond(first, second);
      for (const NodeId node : Spread(in_first, options_.num_nodes)) {
        pairs.emplace_back(first.id, node);
      }
      for (const NodeId node : Spread(in_second, options_.num_nodes)) {
        pairs.emplace_back(second.id, node);
      }
    }
  }
  return pairs;
}

bool SecondLook::IsDue(const SubmapPlace& first, const SubmapPlace& second) const {
  if (tied_.count({first.id, second.id}) > 0) return false;
  const auto last_look = looked_at_.find({first.id, second.id});
  if (last_look == looked_at_.end()) return true;
  const Eigen::Vector2d moved =
      FirstFromSecond(first, second).translation - last_look->second.translation;
  return moved.norm() >= options_.min_distance;
}

}  // namespace loopscope
