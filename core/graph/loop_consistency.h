// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.consistency, not in Cartographer: a loop needs others that say the
/// same. After Mangelson et al., "Pairwise Consistent Measurement Set Maximization", ICRA 2018, in
/// the frame of local SLAM, which hardly drifts over the short ways between the loops compared.
struct LoopConsistencyOptions {
  int min_num_supporters = 0;  ///< loops of other nodes that must agree; 0: off
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

/// Number of nodes other than that of `loop` with a loop among `others` that agrees with it.
int NumSupporters(const LoopDrift& loop, const std::vector<LoopDrift>& others,
                  const LoopConsistencyOptions& options);

}  // namespace loopscope
