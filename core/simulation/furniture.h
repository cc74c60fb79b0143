// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/simulation/floor_plan.h"
#include "core/simulation/random.h"

namespace loopscope {

/// What a room is used for, and so what stands in it.
enum class RoomUse {
  kEmpty,
  kOffice,   ///< desks with chairs at the far wall, cabinets at the left one
  kMeeting,  ///< a long table in the middle with chairs on both sides
  kStorage,  ///< rows of shelves
};

/// Adds the furniture of a room to `plan`. In the frame of the room x runs along the wall with the
/// door and y into the room; `size` is its width and depth [m]. An office leaves its half at
/// the door free, but for the left wall; a meeting room leaves 0.9 m along its walls.
void Furnish(RoomUse use, const Pose2& world_from_room, const Eigen::Vector2d& size, Random* random,
             FloorPlan* plan);

/// A table of `size` [m] as a scanner near the floor sees it: four legs.
void AddTable(const Pose2& world_from_table, const Eigen::Vector2d& size, FloorPlan* plan);

/// A swivel chair: the column in the middle of its star of feet.
void AddChair(const Eigen::Vector2d& center, FloorPlan* plan);

/// The leaf of a door, which reaches from its hinge along the x axis of `world_from_hinge`.
void AddDoorLeaf(const Pose2& world_from_hinge, double width, FloorPlan* plan);

}  // namespace loopscope
