// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/precomputed_grids.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

std::uint8_t ToByte(CellValue value) {
  if (value == kUnknown) return 0;
  return static_cast<std::uint8_t>((255 * (value - 1) + (kMaxCellValue - 1) / 2) /
                                   (kMaxCellValue - 1));
}

}  // namespace

PrecomputedGrid::PrecomputedGrid(const ProbabilityGrid& grid) : box_(grid.KnownBox()) {
  values_.reserve(box_.num_cells());
  for (int y = box_.min.y; y < box_.min.y + box_.height; ++y) {
    for (int x = box_.min.x; x < box_.min.x + box_.width; ++x) {
      values_.push_back(ToByte(grid.value({x, y})));
    }
  }
}

PrecomputedGrid PrecomputedGrid::Coarser() const {
  const int half = 1 << height_;
  PrecomputedGrid coarser;
  coarser.height_ = height_ + 1;
  coarser.box_ = {{box_.min.x - half, box_.min.y - half}, box_.width + half, box_.height + half};
  coarser.values_.assign(coarser.box_.num_cells(), 0);
  // Each value of ours is part of the four blocks that begin at it or `half` lower in x, y or both.
  for (int row = 0; row < box_.height; ++row) {
    const std::uint8_t* from = values_.data() + static_cast<std::size_t>(row) * box_.width;
    for (const int to_row : {row, row + half}) {
      std::uint8_t* to =
          coarser.values_.data() + static_cast<std::size_t>(to_row) * coarser.box_.width;
      for (int x = 0; x < box_.width; ++x) to[x] = std::max(to[x], from[x]);
      for (int x = 0; x < box_.width; ++x) to[x + half] = std::max(to[x + half], from[x]);
    }
  }
  return coarser;
}

PrecomputedGrids::PrecomputedGrids(const ProbabilityGrid& grid, int depth)
    : resolution_(grid.resolution()) {
  grids_.emplace_back(grid);
  while (static_cast<int>(grids_.size()) < depth) grids_.push_back(grids_.back().Coarser());
}

}  // namespace loopscope
