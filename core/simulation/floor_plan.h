// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace loopscope {

/// A straight piece of surface at the height of the scanner, in the frame of the world [m].
struct Segment {
  Eigen::Vector2d from = Eigen::Vector2d::Zero();
  Eigen::Vector2d to = Eigen::Vector2d::Zero();
};

/// An opening in a wall.
struct Door {
  double position = 0.0;  ///< [m] from the beginning of the wall to the middle of the opening
  double width = 0.9;     ///< [m]
};

/// All that a scanner can see of a world, drawn by adding shapes.
class FloorPlan {
 public:
  const std::vector<Segment>& segments() const { return segments_; }

  void AddSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

  /// A closed outline through `corners`.
  void AddPolygon(const std::vector<Eigen::Vector2d>& corners);

  /// A rectangle of `size` [m] (length along x, width along y) centred on `world_from_box`.
  void AddBox(const Pose2& world_from_box, const Eigen::Vector2d& size);

  /// A round column as a regular polygon of 16 corners.
  void AddPillar(const Eigen::Vector2d& center, double radius);

  /// A wall of `thickness` [m] around the line from `from` to `to`, with `doors` left open. The
  /// doors must lie within the wall, in order, without touching one another.
  void AddWall(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
               const std::vector<Door>& doors = {}, double thickness = 0.12);

  /// The four walls of a room between two opposite corners, without doors.
  void AddRoom(const Eigen::Vector2d& low, const Eigen::Vector2d& high);

 private:
  std::vector<Segment> segments_;
};

}  // namespace loopscope
