// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/slam/recording.h"
#include "render/charts/chart_data.h"

namespace loopscope {

/// The chart of a recording as it was after `step`, which must be one of its steps: what came later
/// is not in it.
ChartData ChartOf(const Recording& recording, ChartKind kind, int step);

}  // namespace loopscope
