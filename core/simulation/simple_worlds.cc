// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/random.h"
#include "core/simulation/worlds.h"

namespace loopscope {
namespace {

// One room of the hotel, with its door at y = 0 and its bed and wardrobe.
void AddHotelRoom(const Pose2& world_from_room, FloorPlan* plan) {
  plan->AddBox(world_from_room * Pose2(2.9, 2.6, 0.0), {2.0, 1.6});
  plan->AddBox(world_from_room * Pose2(0.4, 3.0, 0.0), {0.6, 1.2});
}

// `num_rooms` rooms of 4 m x 4.5 m along a wall that begins at `world_from_wall`.
void AddHotelRow(const Pose2& world_from_wall, int num_rooms, FloorPlan* plan) {
  constexpr double kRoomWidth = 4.0;
  constexpr double kRoomDepth = 4.5;
  std::vector<Door> doors;
  for (int i = 0; i <= num_rooms; ++i) {
    const double x = i * kRoomWidth;
    plan->AddWall(world_from_wall * Eigen::Vector2d(x, 0.0),
                  world_from_wall * Eigen::Vector2d(x, kRoomDepth));
    if (i == num_rooms) break;
    doors.push_back({x + 1.0, 0.9});
    AddHotelRoom(world_from_wall * Pose2(x, 0.0, 0.0), plan);
  }
  const double length = num_rooms * kRoomWidth;
  plan->AddWall(world_from_wall.translation, world_from_wall * Eigen::Vector2d(length, 0.0), doors);
  plan->AddWall(world_from_wall * Eigen::Vector2d(0.0, kRoomDepth),
                world_from_wall * Eigen::Vector2d(length, kRoomDepth));
}

}  // namespace

World LoopWorld() {
  World world;
  world.description = "ring of corridors, 20 m x 14 m, with cupboards and pillars, driven twice";
  FloorPlan& plan = world.plan;
  plan.AddRoom({0.0, 0.0}, {20.0, 14.0});
  plan.AddRoom({2.2, 2.2}, {17.8, 11.8});
  // Pilasters and cupboards of different sizes make every stretch its own.
  plan.AddBox(Pose2(4.0, 0.2, 0.0), {0.5, 0.4});
  plan.AddBox(Pose2(9.0, 2.05, 0.0), {1.4, 0.3});
  plan.AddBox(Pose2(14.5, 0.3, 0.0), {0.9, 0.5});
  plan.AddBox(Pose2(19.75, 5.0, 0.0), {0.5, 0.5});
  plan.AddBox(Pose2(17.95, 9.0, 0.0), {0.3, 1.0});
  plan.AddBox(Pose2(15.0, 13.7, 0.0), {2.0, 0.6});
  plan.AddBox(Pose2(8.0, 11.95, 0.0), {0.7, 0.3});
  plan.AddPillar({4.5, 13.6}, 0.3);
  plan.AddBox(Pose2(0.25, 8.0, 0.0), {0.5, 1.5});
  plan.AddPillar({0.3, 4.0}, 0.25);
  world.route = {{3.0, 1.1},  {18.9, 1.1},  {18.9, 12.9}, {1.1, 12.9}, {1.1, 1.1},
                 {18.9, 1.1}, {18.9, 12.9}, {1.1, 12.9},  {1.1, 1.1},  {5.0, 1.1}};
  return world;
}

World WarehouseWorld() {
  World world;
  world.description = "hall, 40 m x 28 m, with rows of racks, pillars and pallets";
  FloorPlan& plan = world.plan;
  plan.AddRoom({0.0, 0.0}, {40.0, 28.0});
  Random random(11);
  for (const double y : {5.0, 11.0, 17.0, 23.0}) {
    plan.AddBox(Pose2(11.5, y, 0.0), {13.0, 1.1});
    plan.AddBox(Pose2(28.5, y, 0.0), {13.0, 1.1});
    plan.AddPillar({20.0, y}, 0.3);
    for (int i = 0; i < 3; ++i) {
      const Pose2 pallet(random.Uniform(6.0, 34.0), y + 1.3, random.Uniform(-0.3, 0.3));
      plan.AddBox(pallet, {1.2, 0.8});
    }
  }
  plan.AddRoom({36.5, 24.5}, {40.0, 28.0});
  plan.AddWall({0.0, 21.0}, {2.0, 21.0});
  world.route = {{3.0, 2.5},   {36.5, 2.5},  {36.5, 8.5}, {3.0, 8.5},  {3.0, 14.5}, {36.5, 14.5},
                 {36.5, 20.5}, {20.0, 20.5}, {3.0, 20.0}, {3.0, 14.5}, {3.0, 2.5},  {12.0, 2.5}};
  return world;
}

World CorridorWorld() {
  World world;
  world.description = "smooth corridor, 90 m x 2.4 m, driven to its end and back: ambiguous";
  world.plan.AddRoom({0.0, 0.0}, {90.0, 2.4});
  world.plan.AddBox(Pose2(0.6, 2.0, 0.0), {1.0, 0.6});
  world.plan.AddPillar({89.0, 0.5}, 0.3);
  world.route = {{2.0, 1.2}, {87.0, 1.2}, {2.0, 1.2}};
  return world;
}

World HotelWorld() {
  World world;
  world.description = "ring of corridors, 36 m x 24 m, with rooms that are all alike: ambiguous";
  FloorPlan& plan = world.plan;
  // Three sides of rooms, the fourth a plain wall; the core is closed.
  AddHotelRow(Pose2(40.5, 4.5, DegreesToRadians(180.0)), 9, &plan);
  AddHotelRow(Pose2(4.5, 28.5, 0.0), 9, &plan);
  AddHotelRow(Pose2(4.5, 4.5, DegreesToRadians(90.0)), 6, &plan);
  plan.AddWall({40.5, 4.5}, {40.5, 28.5});
  plan.AddRoom({6.5, 6.5}, {38.5, 26.5});
  world.route = {{8.0, 5.5}, {39.5, 5.5}, {39.5, 27.5}, {5.5, 27.5},
                 {5.5, 5.5}, {39.5, 5.5}, {39.5, 12.0}};
  return world;
}

}  // namespace loopscope
