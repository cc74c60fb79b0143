// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/seen_area.h"
#include "core/sensor/range_data.h"

namespace loopscope {

struct GraphNode {
  Pose2 local_from_node;
  std::optional<Pose2> odom_from_node;
  SubmapId first_submap;  ///< it was inserted into num_submaps submaps from this one on
  int num_submaps = 0;
  std::shared_ptr<const RangeData> scan;  ///< for loop searches, in the frame of the node
  bool matched_nowhere = false;           ///< see CountedWay

  bool LiesIn(SubmapId submap) const {
    return submap.index >= first_submap.index && submap.index < first_submap.index + num_submaps;
  }
};

struct GraphSubmap {
  Pose2 local_from_submap;
  NodeId first_node;
  int num_nodes = 0;
  Eigen::AlignedBox2d node_box;  ///< around its nodes, in its frame
  double min_loop_score = 0.0;   ///< once it is finished
  double counted_way = 0.0;      ///< [m] to its first node, as CountedWay has it
  std::optional<SeenArea> seen;  ///< once it is finished
};

/// Nodes and submaps by id, with the poses that they have at present.
struct GraphState {
  std::vector<GraphNode> nodes;
  std::vector<GraphSubmap> submaps;
  std::vector<double> node_ways;  ///< [m] that the robot had gone at each node
  std::vector<Pose2> global_from_submap;
  std::vector<Pose2> global_from_node;

  const GraphNode& node(NodeId id) const { return nodes[id.index]; }
  const GraphSubmap& submap(SubmapId id) const { return submaps[id.index]; }

  Pose2 SubmapFromNode(SubmapId submap, NodeId node) const {
    return global_from_submap[submap.index].Inverse() * global_from_node[node.index];
  }
};

}  // namespace loopscope
