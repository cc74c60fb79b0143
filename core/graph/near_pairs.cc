// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/near_pairs.h"

#include <algorithm>

namespace loopscope {
namespace {

const Eigen::Vector2d& PlaceOf(NodeId node, const GraphState& graph) {
  return graph.global_from_node[node.index].translation;
}

/// Of the box around its nodes, in the global frame.
Eigen::Vector2d CenterOf(SubmapId submap, const GraphState& graph) {
  return graph.global_from_submap[submap.index] * graph.submap(submap).node_box.center();
}

/// [m] Of the circle around that box.
double RadiusOf(SubmapId submap, const GraphState& graph) {
  return 0.5 * graph.submap(submap).node_box.diagonal().norm();
}

}  // namespace

void NearPairs::AddNode(NodeId node, const GraphState& graph) {
  node_places_.Add(node.index, PlaceOf(node, graph));
}

void NearPairs::AddFinishedSubmap(SubmapId submap, const GraphState& graph) {
  finished_submaps_.push_back(submap);
  submap_places_.Add(submap.index, CenterOf(submap, graph));
  max_submap_radius_ = std::max(max_submap_radius_, RadiusOf(submap, graph));
}

std::vector<int> NearPairs::SubmapsNear(NodeId node, const GraphState& graph) const {
  return submap_places_.Near(PlaceOf(node, graph), max_submap_radius_ + reach_);
}

std::vector<int> NearPairs::NodesNear(SubmapId submap, const GraphState& graph) const {
  return node_places_.Near(CenterOf(submap, graph), RadiusOf(submap, graph) + reach_);
}

void NearPairs::Renew(const GraphState& graph) {
  submap_places_.Clear();
  for (const SubmapId id : finished_submaps_) submap_places_.Add(id.index, CenterOf(id, graph));
  node_places_.Clear();
  for (int i = 0; i < static_cast<int>(graph.nodes.size()); ++i) AddNode(NodeId{i}, graph);
}

}  // namespace loopscope
