// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <utility>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/seen_area.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.second_look, not in Cartographer: a pair that came up while the
/// map was still bent was searched in the wrong place, and sampling left out many others.
struct SecondLookOptions {
  int num_nodes = 0;          ///< that are searched in a submap of the same place; 0: off
  double max_distance = 3.0;  ///< [m] between a node and the box around the nodes of the submap
  /// [m] between a node and what the submap has seen of free space; 0: any.
  double max_unseen_distance = 0.0;
  double min_way = 20.0;      ///< [m] that the robot went from one to the other
  double min_distance = 2.0;  ///< [m] by which optimizations moved the two since the last look
};

/// A submap as the pose graph has it.
struct SubmapPlace {
  SubmapId id;
  Pose2 global_from_submap;
  Eigen::AlignedBox2d node_box;  ///< around its nodes, in its frame
  NodeId first_node;
  int num_nodes = 0;
  const SeenArea* seen = nullptr;  ///< null if it is not finished: nothing is searched in it
};

/// Finds submaps of the same place that no loop ties, each time that optimizations have moved them.
class SecondLook {
 public:
  using Pair = std::pair<SubmapId, NodeId>;

  explicit SecondLook(const SecondLookOptions& options) : options_(options) {}

  /// A loop was found between the two.
  void Tie(SubmapId a, SubmapId b) { tied_.insert(std::minmax(a, b)); }

  /// The pairs to search now, num_nodes at most for one submap in another, spread over the nodes
  /// that are near, each once. `node_ways` [m] is how far the robot had gone at each node.
  std::vector<Pair> Choose(const std::vector<SubmapPlace>& submaps,
                           const std::vector<Pose2>& global_from_node,
                           const std::vector<double>& node_ways);

  /// Likewise, with the pairs of all submaps that no loop ties, moved or not.
  std::vector<Pair> ChooseOfUntied(const std::vector<SubmapPlace>& submaps,
                                   const std::vector<Pose2>& global_from_node,
                                   const std::vector<double>& node_ways, int num_nodes) const;

 private:
  bool IsTied(SubmapId first, SubmapId second) const { return tied_.count({first, second}) > 0; }
  /// Whether optimizations moved the two since the last look.
  bool HaveMoved(const SubmapPlace& first, const SubmapPlace& second) const;

  SecondLookOptions options_;
  std::set<std::pair<SubmapId, SubmapId>> tied_;
  std::map<std::pair<SubmapId, SubmapId>, Pose2> looked_at_;  ///< first_from_second then
};

}  // namespace loopscope
