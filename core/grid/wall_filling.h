// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/range_data.h"

namespace loopscope {

/// Points of walls between neighbouring returns, `step` [m] apart or less: where two returns are no
/// farther from each other than `max_gap` [m], and lie on a straight line with the one before and
/// the one after. `returns` are in the order of the beams. None if `max_gap` is 0.
///
/// Returns from a far wall, or one that beams graze, stand apart like dots. A scan taken a step
/// ahead has its dots elsewhere, so that it matches best where it is wrong: at the place of the
/// last one.
PointCloud PointsBetween(const PointCloud& returns, double max_gap, double step);

}  // namespace loopscope
