// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/graph/graph_solver.h"

namespace loopscope {

/// The poses of the submaps, then those of the nodes; each with its rotation as a matrix, which is
/// needed more often than it changes.
class GraphPoses {
 public:
  explicit GraphPoses(const GraphProblem& graph) : poses_(graph.global_from_submap) {
    poses_.insert(poses_.end(), graph.global_from_node.begin(), graph.global_from_node.end());
    rotations_.reserve(poses_.size());
    for (const Pose2& pose : poses_) rotations_.push_back(pose.RotationMatrix());
  }

  const std::vector<Pose2>& all() const { return poses_; }
  const Pose2& at(int i) const { return poses_[i]; }
  const Eigen::Matrix2d& rotation(int i) const { return rotations_[i]; }

  /// Moves a pose by `step` [m, m, rad].
  void Move(int i, const Eigen::Vector3d& step) {
    poses_[i].translation += step.head<2>();
    poses_[i].rotation = NormalizeAngle(poses_[i].rotation + step.z());
    rotations_[i] = poses_[i].RotationMatrix();
  }

 private:
  std::vector<Pose2> poses_;
  std::vector<Eigen::Matrix2d> rotations_;
};

/// Which poses are the unknowns: the submaps that are not held, then such nodes.
class GraphUnknowns {
 public:
  explicit GraphUnknowns(const GraphProblem& graph)
      : num_submaps_(static_cast<int>(graph.global_from_submap.size())),
        num_nodes_(static_cast<int>(graph.global_from_node.size())),
        num_held_submaps_(graph.num_held_submaps),
        num_held_nodes_(graph.num_held_nodes) {}

  static constexpr int kHeld = -1;  ///< in place of the number of an unknown

  int count() const { return num_free_submaps() + num_nodes_ - num_held_nodes_; }
  /// The number of the unknown, kHeld if it is none.
  int of(SubmapId id) const {
    return id.index < num_held_submaps_ ? kHeld : id.index - num_held_submaps_;
  }
  int of(NodeId id) const {
    return id.index < num_held_nodes_ ? kHeld : num_free_submaps() + id.index - num_held_nodes_;
  }
  /// In GraphPoses.
  int pose(SubmapId id) const { return id.index; }
  int pose(NodeId id) const { return num_submaps_ + id.index; }

  /// Each unknown moved by its part of `step` [m, m, rad].
  GraphPoses Moved(GraphPoses poses, const Eigen::VectorXd& step) const {
    for (int i = 0; i < count(); ++i) {
      const bool is_submap = i < num_free_submaps();
      const int pose = is_submap ? num_held_submaps_ + i
                                 : num_submaps_ + num_held_nodes_ + i - num_free_submaps();
      poses.Move(pose, step.segment<3>(3 * i));
    }
    return poses;
  }

 private:
  int num_free_submaps() const { return num_submaps_ - num_held_submaps_; }

  int num_submaps_;
  int num_nodes_;
  int num_held_submaps_;
  int num_held_nodes_;
};

}  // namespace loopscope
