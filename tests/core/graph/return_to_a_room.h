// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/graph/pose_graph.h"
#include "tests/support/simulated_room.h"

namespace loopscope {

inline constexpr int kStep = 77;

inline PoseGraphOptions Options() {
  PoseGraphOptions options;
  options.constraint_builder.sampling_ratio = 1.0;
  options.constraint_builder.max_constraint_distance = 3.0;
  options.constraint_builder.fast_correlative_scan_matcher = {0.6, 0.3, 4};
  // Local SLAM is hardly believed from node to node, so that loops can be seen to work.
  options.optimization_problem.local_slam_pose_translation_weight = 1.0;
  options.optimization_problem.local_slam_pose_rotation_weight = 1.0;
  return options;
}

/// The drift of local SLAM when it comes back to the room.
inline const Pose2 kDrift(0.3, -0.2, 0.1);

/// A robot that maps the room as submap 0, and comes back to it in submap 1.
class ReturnToARoom {
 public:
  explicit ReturnToARoom(const PoseGraphOptions& options) : graph_(options, 2) {
    graph_.AddSubmap(Pose2());
    AddNode(Pose2(1.0, 0.5, 0.0), room_.ScanAt(Pose2(1.0, 0.5, 0.0)), 0);
    graph_.FinishSubmap(SubmapId{0}, room_.grid(), 5);
    graph_.AddSubmap(kDrift * Pose2(2.0, 0.8, 0.0));
  }

  /// Adds a node of submap 1 that truly stands at `submap0_from_node`.
  void ComeTo(const Pose2& submap0_from_node) {
    AddNode(kDrift * submap0_from_node, room_.ScanAt(submap0_from_node), 1);
  }

  void AddNode(const Pose2& local_from_node, const PointCloud& points, int submap) {
    graph_.AddNode({local_from_node, std::nullopt, SubmapId{submap}, 1, ScanOf(points)}, kStep);
  }

  PoseGraph& graph() { return graph_; }

 private:
  SimulatedRoom room_;
  PoseGraph graph_;
};

/// Where it stands there.
inline const Pose2 kFirst(2.0, 0.8, 0.4);
inline const Pose2 kSecond(2.3, 0.9, 0.5);

}  // namespace loopscope
