// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/packed_grid.h"

#include <algorithm>
#include <utility>

namespace loopscope {
namespace {

/// Marks a word as the number of times that the value before it is repeated.
constexpr std::uint16_t kIsCount = 0x8000;
constexpr std::size_t kMaxCount = kIsCount - 1;
static_assert(kMaxCellValue < kIsCount);

}  // namespace

PackedGrid::PackedGrid(const ProbabilityGrid& grid)
    : resolution_(grid.resolution()), box_(grid.box()) {
  const std::vector<CellValue>& cells = grid.cells();
  for (auto cell = cells.begin(); cell != cells.end();) {
    const CellValue value = *cell;
    const auto end = std::find_if(cell, cells.end(), [&](CellValue v) { return v != value; });
    const std::size_t run = std::min<std::size_t>(end - cell, kMaxCount + 1);
    words_.push_back(value);
    if (run > 1) words_.push_back(static_cast<std::uint16_t>(kIsCount | (run - 1)));
    cell += static_cast<std::ptrdiff_t>(run);
  }
  words_.shrink_to_fit();
}

ProbabilityGrid PackedGrid::Unpack() const {
  std::vector<CellValue> cells(box_.num_cells());
  auto cell = cells.begin();
  for (const std::uint16_t word : words_) {
    if ((word & kIsCount) == 0) {
      *cell++ = word;
    } else {
      cell = std::fill_n(cell, word & kMaxCount, *(cell - 1));
    }
  }
  return ProbabilityGrid(resolution_, box_, std::move(cells));
}

}  // namespace loopscope
