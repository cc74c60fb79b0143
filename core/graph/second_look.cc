// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/second_look.h"

#include <algorithm>

#include "core/graph/near_boxes.h"

namespace loopscope {
namespace {

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

/// In the global frame: a box around the nodes of a submap, and around the box that it has of them.
Eigen::AlignedBox2d ExtentOf(const SubmapPlace& submap,
                             const std::vector<Pose2>& global_from_node) {
  Eigen::AlignedBox2d extent;
  for (int i = 0; i < submap.num_nodes; ++i) {
    extent.extend(global_from_node[submap.first_node.index + i].translation);
  }
  for (int i = 0; i < 4; ++i) {
    const auto corner = static_cast<Eigen::AlignedBox2d::CornerType>(i);
    extent.extend(submap.global_from_submap * Eigen::Vector2d(submap.node_box.corner(corner)));
  }
  return extent;
}

/// Visits all two submaps between whose nodes there could be no more than `max_distance` [m].
template <typename Visitor>
void ForEachTwoNear(const std::vector<SubmapPlace>& submaps,
                    const std::vector<Pose2>& global_from_node, double max_distance,
                    const Visitor& visit) {
  std::vector<Eigen::AlignedBox2d> extents;
  for (const SubmapPlace& submap : submaps) extents.push_back(ExtentOf(submap, global_from_node));
  for (const auto& [second, first] : NearBoxes(extents, max_distance)) {
    visit(submaps[first], submaps[second]);
  }
}

/// Each pair once: a node lies in two submaps, and so may come up for both.
void RemoveRepeated(std::vector<SecondLook::Pair>* pairs) {
  std::set<SecondLook::Pair> seen;
  const auto is_repeated = [&](const SecondLook::Pair& pair) { return !seen.insert(pair).second; };
  pairs->erase(std::remove_if(pairs->begin(), pairs->end(), is_repeated), pairs->end());
}

/// Tells whether submaps show the same place, by their nodes.
struct SamePlace {
  const std::vector<Pose2>& global_from_node;
  const std::vector<double>& node_ways;  ///< [m]
  const SecondLookOptions& options;
  int num_nodes;  ///< of one submap to search in the other, at most

  /// Adds nodes of each of the two that are near to the other; whether there were any.
  bool AddPairs(const SubmapPlace& first, const SubmapPlace& second,
                std::vector<SecondLook::Pair>* pairs) const {
    const std::size_t num_pairs = pairs->size();
    for (const auto& [submap, other] : {std::pair(&first, &second), std::pair(&second, &first)}) {
      if (submap->seen == nullptr) continue;
      for (const NodeId node : Spread(NearNodes(*submap, *other), num_nodes)) {
        pairs->emplace_back(submap->id, node);
      }
    }
    return pairs->size() > num_pairs;
  }

 private:
  /// The nodes of `other` that are near the nodes of `submap`, but far from them along the way.
  std::vector<NodeId> NearNodes(const SubmapPlace& submap, const SubmapPlace& other) const {
    const double first_way = node_ways[submap.first_node.index];
    const double last_way = node_ways[submap.first_node.index + submap.num_nodes - 1];
    const Pose2 submap_from_global = submap.global_from_submap.Inverse();
    std::vector<NodeId> nodes;
    for (int i = 0; i < other.num_nodes; ++i) {
      const NodeId node{other.first_node.index + i};
      const double way = node_ways[node.index];
      if (way > first_way - options.min_way && way < last_way + options.min_way) continue;
      const Eigen::Vector2d place = submap_from_global * global_from_node[node.index].translation;
      if (submap.node_box.exteriorDistance(place) > options.max_distance) continue;
      if (IsSeen(submap, place)) nodes.push_back(node);
    }
    return nodes;
  }

  bool IsSeen(const SubmapPlace& submap, const Eigen::Vector2d& place) const {
    return options.max_unseen_distance == 0.0 ||
           submap.seen->DistanceTo(place) <= options.max_unseen_distance;
  }
};

}  // namespace

std::vector<SecondLook::Pair> SecondLook::Choose(const std::vector<SubmapPlace>& submaps,
                                                 const std::vector<Pose2>& global_from_node,
                                                 const std::vector<double>& node_ways) {
  std::vector<Pair> pairs;
  if (options_.num_nodes == 0) return pairs;
  const SamePlace same_place{global_from_node, node_ways, options_, options_.num_nodes};
  ForEachTwoNear(submaps, global_from_node, options_.max_distance,
                 [&](const SubmapPlace& first, const SubmapPlace& second) {
                   if (IsTied(first.id, second.id) || !HaveMoved(first, second)) return;
                   if (!same_place.AddPairs(first, second, &pairs)) return;
                   looked_at_[{first.id, second.id}] = FirstFromSecond(first, second);
                 });
  RemoveRepeated(&pairs);
  return pairs;
}

std::vector<SecondLook::Pair> SecondLook::ChooseOfUntied(const std::vector<SubmapPlace>& submaps,
                                                         const std::vector<Pose2>& global_from_node,
                                                         const std::vector<double>& node_ways,
                                                         int num_nodes) const {
  std::vector<Pair> pairs;
  if (num_nodes == 0) return pairs;
  const SamePlace same_place{global_from_node, node_ways, options_, num_nodes};
  ForEachTwoNear(submaps, global_from_node, options_.max_distance,
                 [&](const SubmapPlace& first, const SubmapPlace& second) {
                   if (!IsTied(first.id, second.id)) same_place.AddPairs(first, second, &pairs);
                 });
  RemoveRepeated(&pairs);
  return pairs;
}

bool SecondLook::HaveMoved(const SubmapPlace& first, const SubmapPlace& second) const {
  const auto last_look = looked_at_.find({first.id, second.id});
  if (last_look == looked_at_.end()) return true;
  const Eigen::Vector2d moved =
      FirstFromSecond(first, second).translation - last_look->second.translation;
  return moved.norm() >= options_.min_distance;
}

}  // namespace loopscope
