// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/grid/cell.h"

namespace loopscope {

class PrecomputedGrid;

// The inner loops of the searches, for whatever vectors the processor has. They compute
// with integers only, and so give the same on all processors.

/// Blocks of a square of the search tree, row-major, lowest y first.
constexpr int kBlocksPerSide = 8;
using BlockSums = std::array<std::int32_t, kBlocksPerSide * kBlocksPerSide>;

/// The sums of eq. 16 for 8 x 8 neighbouring blocks at once, the first at `offset`, the others
/// `grid.stride()` apart: entry (i, j) is the sum of the values of `grid` at cells + offset +
/// stride * (i, j), for j < `num_rows`, 1 to 8; what the others hold is not said.
BlockSums SumBlocks(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                    CellIndex offset, int num_rows = kBlocksPerSide);

/// The largest of `num_rows` x `num_columns` entries of BlockSums, of which `first` is the first.
/// Memory up to the next multiple of four columns is read.
std::int32_t MaxOfBlocks(const std::int32_t* first, int num_rows, int num_columns);

/// values[i] = max(values[i], values[i + shift]) for i = 0 ... count - 1, in this order.
void MaximaOfShifted(std::uint8_t* values, std::size_t shift, std::size_t count);

/// even[i] = values[2 i], odd[i] = values[2 i + 1] for i = 0 ... count - 1.
void SplitEvenOdd(const std::uint8_t* values, std::size_t count, std::uint8_t* even,
                  std::uint8_t* odd);

}  // namespace loopscope
