// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// Rows of cells are read in steps of so many, or fewer.
constexpr int kCellsPerLoad = 8;

/// Square windows of a grid.
struct Windows {
  const CellValue* cells;
  int width;                   ///< from a row of the grid to the next
  const std::int32_t* starts;  ///< their first cells are so far after `cells`
  std::size_t count;
};

/// Adds what the cells have at each shift of a square window, |x|, |y| <= `radius` cells, to its
/// StepsAboveMin in `sums`; row-major, lowest y first. The same on any processor.
void AddShifted(const ProbabilityGrid& grid, const CellIndex* cells, std::size_t num_cells,
                int radius, std::uint32_t* sums);

}  // namespace loopscope
