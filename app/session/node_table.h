// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/session/table.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// All nodes of the recording, row i is node i, with their poses and loops in `state`; those of
/// later nodes are not known.
Table MakeNodeTable(const Recording& recording, const MapState& state);

}  // namespace loopscope
