// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/probability_grid.h"

namespace loopscope {

/// The grid as scans are matched with it: cells that are rather occupied than not are walls, and
/// each of the eight cells around a wall is one, too, of `share_beside` of its value, in [0, 1], if
/// it is none of a higher one. All other cells that are known are certainly free, as good as
/// unknown.
///
/// A far wall, or one that beams graze, is a row of dots in a grid. A scan from a step ahead has
/// its dots elsewhere: of all places along the wall it fits best where it is wrong, at that of the
/// scan before, unless dots are wide. After the lookup table of Olson, "Real-Time Correlative Scan
/// Matching", ICRA 2009, which is blurred by the noise of a range.
ProbabilityGrid WithWideWalls(const ProbabilityGrid& grid, double share_beside);

}  // namespace loopscope
