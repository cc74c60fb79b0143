// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/simulation/world.h"

namespace loopscope {

// The built-in worlds, without their names.

/// An office floor of 36 m x 22 m: a ring of corridors with one across (two loops), furnished rooms
/// with open and closed doors, a lounge and a lobby.
World OfficeWorld();

/// A small ring of corridors with cupboards of different sizes, driven twice.
World LoopWorld();

/// A hall of 40 m x 28 m with rows of racks and pillars, seen far across.
World WarehouseWorld();

/// Ambiguous: a smooth corridor so long that no end is in sight from its middle.
World CorridorWorld();

/// Ambiguous: a ring of corridors with rooms that are all alike.
World HotelWorld();

}  // namespace loopscope
