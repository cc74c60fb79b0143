// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/pose_graph_options.h"

namespace loopscope {

/// How a node stands to the one before it, as local SLAM or odometry has it.
struct ConsecutiveNodes {
  NodeId first;
  NodeId second;
  Pose2 first_from_second;
  double translation_weight = 0.0;  ///< [1/m]
  double rotation_weight = 0.0;     ///< [1/rad]
};

/// A node in the frames of local SLAM and, if it is used, of odometry.
struct MeasuredNode {
  NodeId id;
  Pose2 local_from_node;
  std::optional<Pose2> odom_from_node;
};

/// The terms between two consecutive nodes: none, one or two, as the weights have it.
std::vector<ConsecutiveNodes> RelateConsecutive(const MeasuredNode& first,
                                                const MeasuredNode& second,
                                                const OptimizationProblemOptions& options);

}  // namespace loopscope
