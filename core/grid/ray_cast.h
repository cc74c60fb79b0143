// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/cell.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// Holds every cell that a ray within `extent` [m] may cross, and one more all around against
/// rounding. Throws std::length_error if these are more than `max_num_cells`, or as BoxOf.
CellBox BoxOfRays(const Eigen::AlignedBox2d& extent, double resolution,
                  std::int64_t max_num_cells = kMaxNumCells);

/// The cells that `data` (in the frame of the grid) observes on a lattice of edge `resolution` [m].
/// Hits are the cells of the returns; misses are all other cells whose pixel is crossed by a ray
/// from the origin to a return or to the end of a miss, exactly, not only to the nearest cell. A
/// cell appears at most once. Hits are in the order of the returns, misses row by row.
/// Hits are also the cells of walls between returns up to `max_wall_gap` [m] apart, see
/// PointsBetween. Throws std::length_error if a ray leads so far that its cells do not fit in
/// memory.
ScanCells CastRays(const RangeData& data, double resolution, double max_wall_gap = 0.0);

}  // namespace loopscope
