// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/furniture.h"
#include "core/simulation/worlds.h"

namespace loopscope {
namespace {

// The floor [m]. Corridors are 2 m wide, between the outer rooms and the core.
constexpr double kWidth = 36.0;
constexpr double kDepth = 22.0;
constexpr double kRing = 5.5;          // depth of the outer rooms
constexpr double kCore = kRing + 2.0;  // where the core begins
constexpr double kCoreEastEnd = kWidth - kCore;
constexpr double kCoreNorthEnd = kDepth - kCore;
constexpr double kCrossWest = 16.5;  // the corridor across
constexpr double kCrossEast = 18.5;

enum class DoorState { kOpen, kClosed };

// An outer room, as stretch of the wall of its corridor.
struct Room {
  double from;  // [m] along the wall, from its beginning
  double to;
  double door;  // middle of its door
  DoorState door_state;
  RoomUse use;
};

// A row of rooms along a wall that begins at `world_from_wall` and runs along x; rooms lie at y >
// 0.
void AddRow(const Pose2& world_from_wall, double length, const std::vector<Room>& rooms,
            Random* random, FloorPlan* plan) {
  constexpr double kDoorWidth = 1.0;
  std::vector<Door> doors;
  for (const Room& room : rooms) doors.push_back({room.door, kDoorWidth});
  plan->AddWall(world_from_wall.translation, world_from_wall * Eigen::Vector2d(length, 0.0), doors);
  for (const Room& room : rooms) {
    const double swing =
        room.door_state == DoorState::kOpen ? DegreesToRadians(random->Uniform(86.0, 105.0)) : 0.0;
    const Pose2 wall_from_hinge(room.door - kDoorWidth / 2.0, 0.03, swing);
    AddDoorLeaf(world_from_wall * wall_from_hinge, kDoorWidth, plan);
    plan->AddWall(world_from_wall * Eigen::Vector2d(room.to, 0.0),
                  world_from_wall * Eigen::Vector2d(room.to, kRing));
    Furnish(room.use, world_from_wall * Pose2(room.from, 0.0, 0.0), {room.to - room.from, kRing},
            random, plan);
  }
}

void AddSouthRooms(Random* random, FloorPlan* plan) {
  // The wall runs from east to west, so that the rooms lie to its left.
  AddRow(Pose2(kWidth - kRing, kRing, DegreesToRadians(180.0)), kWidth - 2.0 * kRing,
         {{-5.5, 5.0, 1.2, DoorState::kClosed, RoomUse::kStorage},
          {5.0, 9.0, 6.1, DoorState::kOpen, RoomUse::kOffice},
          {9.0, 13.5, 12.4, DoorState::kOpen, RoomUse::kOffice},
          {13.5, 17.5, 14.6, DoorState::kOpen, RoomUse::kOffice},
          {17.5, 21.5, 18.7, DoorState::kClosed, RoomUse::kOffice},
          {21.5, 30.5, 23.0, DoorState::kOpen, RoomUse::kMeeting}},
         random, plan);
}

void AddNorthRooms(Random* random, FloorPlan* plan) {
  AddRow(Pose2(kRing, kDepth - kRing, 0.0), kWidth - 2.0 * kRing,
         {{-5.5, 2.0, 1.2, DoorState::kOpen, RoomUse::kOffice},
          {2.0, 6.0, 3.1, DoorState::kOpen, RoomUse::kOffice},
          {6.0, 10.0, 8.9, DoorState::kClosed, RoomUse::kOffice},
          {10.0, 14.5, 11.2, DoorState::kOpen, RoomUse::kOffice},
          {14.5, 18.5, 16.5, DoorState::kOpen, RoomUse::kOffice},
          {18.5, 22.5, 19.6, DoorState::kOpen, RoomUse::kStorage},
          {22.5, 30.5, 24.0, DoorState::kClosed, RoomUse::kMeeting}},
         random, plan);
}

void AddWestRooms(Random* random, FloorPlan* plan) {
  AddRow(Pose2(kRing, kRing, DegreesToRadians(90.0)), kDepth - 2.0 * kRing,
         {{0.0, 4.0, 1.1, DoorState::kOpen, RoomUse::kOffice},
          {4.0, 7.5, 6.4, DoorState::kOpen, RoomUse::kStorage},
          {7.5, 11.0, 8.6, DoorState::kClosed, RoomUse::kOffice}},
         random, plan);
}

// The lobby in the east, behind a wide opening: reception, pillars, seats and a slanted wall.
void AddLobby(FloorPlan* plan) {
  const double x = kWidth - kRing;
  plan->AddWall({x, kRing}, {x, kDepth - kRing}, {{5.5, 3.0}});
  plan->AddWall({x, kDepth - kRing}, {kWidth, kDepth - kRing});
  plan->AddWall({x, kRing}, {kWidth, kRing});
  plan->AddWall({x + 2.5, kRing}, {kWidth, kRing + 2.8});
  plan->AddPillar({x + 1.2, 8.0}, 0.25);
  plan->AddPillar({x + 1.2, 14.0}, 0.25);
  plan->AddPillar({kWidth - 1.7, kDepth - kRing - 1.8}, 0.9);
  plan->AddBox(Pose2(x + 1.0, kDepth - kRing - 0.5, 0.0), {1.6, 0.7});
}

// The western core: a lounge between openings to three corridors.
void AddLounge(FloorPlan* plan) {
  plan->AddWall({kCore, kCore}, {kCrossWest, kCore});
  plan->AddWall({kCore, kCoreNorthEnd}, {kCrossWest, kCoreNorthEnd}, {{6.8, 2.4}});
  plan->AddWall({kCore, kCore}, {kCore, kCoreNorthEnd}, {{3.5, 2.0}});
  plan->AddWall({kCrossWest, kCore}, {kCrossWest, kCoreNorthEnd}, {{3.5, 1.6}});
  plan->AddBox(Pose2(kCore + 2.4, kCore + 0.5, 0.0), {4.2, 0.65});
  plan->AddBox(Pose2(kCore + 6.6, kCore + 1.2, DegreesToRadians(20.0)), {1.9, 0.8});
  plan->AddBox(Pose2(kCore + 2.0, kCoreNorthEnd - 1.0, DegreesToRadians(-8.0)), {1.8, 0.8});
  plan->AddPillar({kCore + 4.4, kCoreNorthEnd - 1.1}, 0.35);
  plan->AddPillar({kCore + 3.0, kCore + 2.0}, 0.05);
  plan->AddPillar({kCore + 8.4, kCoreNorthEnd - 0.6}, 0.2);
}

// The eastern core: stairs, lifts and a room of machines, all behind closed walls with niches.
void AddStairs(FloorPlan* plan) {
  const double niche = 0.8;
  plan->AddWall({kCrossEast, kCore}, {kCoreEastEnd, kCore}, {{3.0, 1.8}, {7.4, 1.2}});
  plan->AddWall({kCrossEast + 2.1, kCore + niche}, {kCrossEast + 3.9, kCore + niche});
  plan->AddWall({kCrossEast + 6.8, kCore + niche}, {kCrossEast + 8.0, kCore + niche});
  for (const double x : {2.1, 3.9, 6.8, 8.0}) {
    plan->AddWall({kCrossEast + x, kCore}, {kCrossEast + x, kCore + niche});
  }
  plan->AddWall({kCrossEast, kCoreNorthEnd}, {kCoreEastEnd, kCoreNorthEnd});
  plan->AddWall({kCrossEast, kCore}, {kCrossEast, kCoreNorthEnd});
  plan->AddWall({kCoreEastEnd, kCore}, {kCoreEastEnd, kCoreNorthEnd});
}

void AddCorridorThings(FloorPlan* plan) {
  plan->AddBox(Pose2(11.5, kCore - 0.25, 0.0), {1.2, 0.38});
  plan->AddBox(Pose2(25.6, kCoreNorthEnd + 0.25, 0.0), {0.9, 0.38});
  plan->AddPillar({kRing + 0.35, 10.9}, 0.18);
  plan->AddPillar({kCrossEast - 0.3, 12.9}, 0.18);
}

// From the lobby along the northern corridor with a look into two rooms, down the western one,
// around the table of the meeting room and into an office; by the corridor across and the lounge to
// the west, which closes the first loop; and along the northern and southern corridors to the
// lobby.
std::vector<Eigen::Vector2d> Route() {
  return {{33.0, 11.0}, {29.5, 11.0}, {29.5, 15.5}, {22.0, 15.5}, {22.0, 18.6}, {22.0, 15.6},
          {8.6, 15.5},  {8.6, 18.3},  {8.6, 15.6},  {6.5, 15.3},  {6.5, 6.5},   {7.5, 5.6},
          {7.5, 4.7},   {1.0, 4.75},  {0.9, 0.75},  {7.5, 0.75},  {7.4, 3.6},   {7.5, 5.0},
          {7.6, 6.2},   {15.9, 6.4},  {15.9, 3.4},  {15.9, 6.2},  {17.3, 6.4},  {17.5, 11.0},
          {14.0, 11.0}, {9.0, 11.0},  {6.5, 11.2},  {6.5, 15.5},  {17.5, 15.5}, {17.5, 6.5},
          {29.5, 6.5},  {29.5, 11.0}, {33.0, 11.0}};
}

}  // namespace

World OfficeWorld() {
  World world;
  world.description =
      "office floor, 36 m x 22 m: a ring of corridors with one across, furnished rooms, a lobby";
  Random random(7);
  world.plan.AddRoom({0.0, 0.0}, {kWidth, kDepth});
  AddSouthRooms(&random, &world.plan);
  AddNorthRooms(&random, &world.plan);
  AddWestRooms(&random, &world.plan);
  AddLobby(&world.plan);
  AddLounge(&world.plan);
  AddStairs(&world.plan);
  AddCorridorThings(&world.plan);
  world.route = Route();
  return world;
}

}  // namespace loopscope
