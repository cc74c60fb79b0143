// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/consecutive_nodes.h"

#include "core/geometry/leap.h"

namespace loopscope {

std::vector<ConsecutiveNodes> RelateConsecutive(const MeasuredNode& first,
                                                const MeasuredNode& second,
                                                const OptimizationProblemOptions& options) {
  std::vector<ConsecutiveNodes> terms;
  const auto add = [&](const Pose2& first_from_second, double translation, double rotation) {
    if (translation == 0.0 && rotation == 0.0) return;
    terms.push_back({first.id, second.id, first_from_second, translation, rotation});
  };
  add(first.local_from_node.Inverse() * second.local_from_node,
      options.local_slam_pose_translation_weight, options.local_slam_pose_rotation_weight);
  if (!first.odom_from_node || !second.odom_from_node) return terms;
  const Pose2 measured = first.odom_from_node->Inverse() * *second.odom_from_node;
  // It may have leaped at a scan between them.
  if (IsLeap(measured)) return terms;
  add(measured, options.odometry_translation_weight, options.odometry_rotation_weight);
  return terms;
}

}  // namespace loopscope
