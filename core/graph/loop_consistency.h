// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/loop_candidate.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.consistency, not in Cartographer: a loop needs others that say the
/// same. After Mangelson et al., "Pairwise Consistent Measurement Set Maximization", ICRA 2018, in
/// the frame of local SLAM, which hardly drifts over the short ways between the loops compared.
struct LoopConsistencyOptions {
  int min_num_supporters = 0;  ///< loops of other nodes that must agree; 0: off
  /// One fewer is enough for a loop that scores so many times as much as it must; 0: for none.
  double good_score_ratio = 0.0;
  double min_way = 0.0;  ///< [m] loops of nodes nearer to each other count as one
  /// Of the nodes near that of a loop without support, so many that sampling left out are searched
  /// where that loop has them.
  int num_checked_neighbors = 0;
  double max_way = 20.0;      ///< [m] between the nodes, and between the submaps, of two such loops
  double max_distance = 0.2;  ///< [m] that two loops may differ
  double max_distance_per_meter = 0.02;      ///< on top, for each metre of way between them
  double max_angle = DegreesToRadians(2.0);  ///< [rad]
};

/// A loop as local SLAM sees it: the robot came back to where it had been, with a drift of
/// `drift` = local_from_submap * submap_from_node * node_from_local.
struct LoopDrift {
  NodeId node;
  Pose2 local_from_node;
  Pose2 drift;
  double node_way = 0.0;    ///< [m] that the robot had gone at the node
  double submap_way = 0.0;  ///< [m] that it had gone where the submap begins
};

/// Whether two loops say the same of the drift.
bool Agree(const LoopDrift& a, const LoopDrift& b, const LoopConsistencyOptions& options);

/// Many loops, of which only those that a loop may be compared with are looked at.
class LoopDrifts {
 public:
  void Add(const LoopDrift& loop) { by_node_way_.emplace(loop.node_way, loop); }
  std::size_t size() const { return by_node_way_.size(); }

  /// Adds the loops of nodes no farther than `max_way` [m] from that of `loop` to `near`.
  void AddNear(const LoopDrift& loop, double max_way, std::vector<LoopDrift>* near) const;

 private:
  std::multimap<double, LoopDrift> by_node_way_;
};

/// Number of nodes with a loop among `others` that agrees with `loop`, of those that are min_way
/// from its node and from each other.
int NumSupporters(const LoopDrift& loop, const std::vector<LoopDrift>& others,
                  const LoopConsistencyOptions& options);

/// How many supporters a loop needs, by its score.
int MinNumSupporters(const LoopCandidate& loop, const LoopConsistencyOptions& options);

/// Loops that were found, and what sampling left out: of `left_out` (nodes that came up for the
/// same submap) those to search to check the loop of `node`, at most num_checked_neighbors, next to
/// it and min_way apart. `node_ways` [m] is how far the robot had gone at each node.
std::vector<NodeId> NeighborsToCheck(NodeId node, const std::vector<NodeId>& left_out,
                                     const std::vector<double>& node_ways,
                                     const LoopConsistencyOptions& options);

}  // namespace loopscope
