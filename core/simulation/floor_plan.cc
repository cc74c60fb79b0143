// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/floor_plan.h"

#include <cassert>
#include <cmath>

namespace loopscope {

void FloorPlan::AddSegment(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  segments_.push_back({from, to});
}

void FloorPlan::AddPolygon(const std::vector<Eigen::Vector2d>& corners) {
  for (size_t i = 0; i < corners.size(); ++i) {
    AddSegment(corners[i], corners[(i + 1) % corners.size()]);
  }
}

void FloorPlan::AddBox(const Pose2& world_from_box, const Eigen::Vector2d& size) {
  const double x = size.x() / 2.0;
  const double y = size.y() / 2.0;
  AddPolygon({world_from_box * Eigen::Vector2d(-x, -y), world_from_box * Eigen::Vector2d(x, -y),
              world_from_box * Eigen::Vector2d(x, y), world_from_box * Eigen::Vector2d(-x, y)});
}

void FloorPlan::AddPillar(const Eigen::Vector2d& center, double radius) {
  constexpr int kNumCorners = 16;
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < kNumCorners; ++i) {
    const double angle = DegreesToRadians(360.0 * i / kNumCorners);
    corners.push_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  AddPolygon(corners);
}

void FloorPlan::AddWall(const Eigen::Vector2d& from, const Eigen::Vector2d& to,
                        const std::vector<Door>& doors, double thickness) {
  const Eigen::Vector2d along = to - from;
  const double length = along.norm();
  const Pose2 world_from_wall(from, std::atan2(along.y(), along.x()));
  const auto add_piece = [&](double begin, double end) {
    assert(begin < end);
    AddBox(world_from_wall * Pose2((begin + end) / 2.0, 0.0, 0.0), {end - begin, thickness});
  };
  // Half a thickness more at both ends closes the corners with other walls.
  double begin = -thickness / 2.0;
  for (const Door& door : doors) {
    add_piece(begin, door.position - door.width / 2.0);
    begin = door.position + door.width / 2.0;
  }
  add_piece(begin, length + thickness / 2.0);
}

void FloorPlan::AddRoom(const Eigen::Vector2d& low, const Eigen::Vector2d& high) {
  AddWall({low.x(), low.y()}, {high.x(), low.y()});
  AddWall({high.x(), low.y()}, {high.x(), high.y()});
  AddWall({high.x(), high.y()}, {low.x(), high.y()});
  AddWall({low.x(), high.y()}, {low.x(), low.y()});
}

}  // namespace loopscope
