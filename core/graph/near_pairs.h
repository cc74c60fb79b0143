// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/graph/graph_state.h"
#include "core/graph/place_index.h"

namespace loopscope {

/// Finds the pairs of a node and a finished submap that a loop gate may let through, without
/// looking at all of them. Places are those of `graph` when they were added, or renewed.
class NearPairs {
 public:
  /// No node farther than `reach` [m] from the nodes of a submap comes up for a search in it.
  explicit NearPairs(double reach) : reach_(reach) {}

  void AddNode(NodeId node, const GraphState& graph);
  void AddFinishedSubmap(SubmapId submap, const GraphState& graph);

  /// In the order in which they were added.
  const std::vector<SubmapId>& finished_submaps() const { return finished_submaps_; }

  /// All finished submaps in reach of the node, and some that are not, ascending.
  std::vector<int> SubmapsNear(NodeId node, const GraphState& graph) const;
  /// All nodes in reach of the submap, and some that are not, ascending.
  std::vector<int> NodesNear(SubmapId submap, const GraphState& graph) const;

  /// After an optimization has moved all places.
  void Renew(const GraphState& graph);

 private:
  double reach_;
  PlaceIndex node_places_;
  PlaceIndex submap_places_;  ///< of the centers of finished submaps
  std::vector<SubmapId> finished_submaps_;
  double max_submap_radius_ = 0.0;  ///< [m] of the circles around their node boxes
};

}  // namespace loopscope
