// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "app/session/table.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// All submaps of the recording, row i is submap i, as they were in `state`. Of what was begun
/// later only that is known.
Table MakeSubmapTable(const Recording& recording, const MapState& state);

}  // namespace loopscope
