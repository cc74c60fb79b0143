// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/furniture.h"

#include <cmath>

namespace loopscope {
namespace {

// A desk that one sits at from the side of lower y, with its drawers and its chair.
void AddDesk(const Pose2& world_from_desk, Random* random, FloorPlan* plan) {
  AddTable(world_from_desk, {1.6, 0.8}, plan);
  const double drawer_side = random->Uniform() < 0.5 ? -1.0 : 1.0;
  plan->AddBox(world_from_desk * Pose2(0.5 * drawer_side, 0.05, 0.0), {0.42, 0.6});
  const Eigen::Vector2d chair(random->Uniform(-0.3, 0.3), random->Uniform(-0.75, -0.55));
  AddChair(world_from_desk * chair, plan);
}

void FurnishOffice(const Pose2& world_from_room, const Eigen::Vector2d& size, Random* random,
                   FloorPlan* plan) {
  constexpr double kSpacePerDesk = 1.9;
  constexpr double kCabinetDepth = 0.45;
  const int num_desks = static_cast<int>(size.x() / kSpacePerDesk);
  for (int i = 0; i < num_desks; ++i) {
    const double x = size.x() * (i + 0.5) / num_desks + random->Uniform(-0.08, 0.08);
    AddDesk(world_from_room * Pose2(x, size.y() - 0.55, random->Uniform(-0.04, 0.04)), random,
            plan);
  }
  const int num_cabinets = 1 + random->Below(2);
  for (int i = 0; i < num_cabinets; ++i) {
    const double y = 1.75 + 0.95 * i;
    plan->AddBox(world_from_room * Pose2(0.08 + kCabinetDepth / 2.0, y, 0.0), {kCabinetDepth, 0.9});
  }
  plan->AddPillar(world_from_room * Eigen::Vector2d(size.x() - 0.35, 0.35), 0.15);
}

void FurnishMeeting(const Pose2& world_from_room, const Eigen::Vector2d& size, Random* random,
                    FloorPlan* plan) {
  const Eigen::Vector2d table(size.x() - 4.6, size.y() - 4.3);
  const Pose2 world_from_table = world_from_room * Pose2(size.x() / 2.0, size.y() / 2.0, 0.0);
  AddTable(world_from_table, table, plan);
  plan->AddBox(world_from_table, {table.x() / 2.0, 0.3});
  const int num_chairs = static_cast<int>(table.x() / 0.9);
  for (int i = 0; i < num_chairs; ++i) {
    const double x = table.x() * ((i + 0.5) / num_chairs - 0.5) + random->Uniform(-0.1, 0.1);
    const double y = table.y() / 2.0 + random->Uniform(0.05, 0.3);
    AddChair(world_from_table * Eigen::Vector2d(x, y), plan);
    AddChair(world_from_table * Eigen::Vector2d(x, -y), plan);
  }
}

void FurnishStorage(const Pose2& world_from_room, const Eigen::Vector2d& size, FloorPlan* plan) {
  constexpr double kRowSpacing = 1.4;
  constexpr double kShelfDepth = 0.4;
  const int num_rows = static_cast<int>((size.x() - kShelfDepth) / kRowSpacing) + 1;
  for (int i = 0; i < num_rows; ++i) {
    const double x = 0.08 + kShelfDepth / 2.0 + i * kRowSpacing;
    plan->AddBox(world_from_room * Pose2(x, size.y() / 2.0 + 0.7, 0.0),
                 {kShelfDepth, size.y() - 1.8});
  }
}

}  // namespace

void Furnish(RoomUse use, const Pose2& world_from_room, const Eigen::Vector2d& size, Random* random,
             FloorPlan* plan) {
  switch (use) {
    case RoomUse::kEmpty:
      return;
    case RoomUse::kOffice:
      return FurnishOffice(world_from_room, size, random, plan);
    case RoomUse::kMeeting:
      return FurnishMeeting(world_from_room, size, random, plan);
    case RoomUse::kStorage:
      return FurnishStorage(world_from_room, size, plan);
  }
}

void AddTable(const Pose2& world_from_table, const Eigen::Vector2d& size, FloorPlan* plan) {
  constexpr double kLeg = 0.06;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      const Pose2 table_from_leg(x * (size.x() - kLeg), y * (size.y() - kLeg), 0.0);
      plan->AddBox(world_from_table * table_from_leg, {kLeg, kLeg});
    }
  }
}

void AddChair(const Eigen::Vector2d& center, FloorPlan* plan) { plan->AddPillar(center, 0.12); }

void AddDoorLeaf(const Pose2& world_from_hinge, double width, FloorPlan* plan) {
  constexpr double kThickness = 0.04;
  plan->AddBox(world_from_hinge * Pose2(width / 2.0, 0.0, 0.0), {width, kThickness});
}

}  // namespace loopscope
