// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/probability_grid.h"

#include <algorithm>
#include <cassert>

namespace loopscope {

void ProbabilityGrid::GrowToInclude(const CellBox& box) {
  const CellBox grown = Union(box_, box);
  if (grown.min == box_.min && grown.width == box_.width && grown.height == box_.height) return;
  std::vector<CellValue> cells(grown.num_cells(), kUnknown);
  for (int row = 0; row < box_.height; ++row) {
    const auto from = cells_.begin() + static_cast<std::ptrdiff_t>(row) * box_.width;
    std::copy(from, from + box_.width,
              cells.begin() + grown.FlatIndex({box_.min.x, box_.min.y + row}));
  }
  box_ = grown;
  cells_ = std::move(cells);
}

void ProbabilityGrid::Update(const std::vector<CellIndex>& cells, const OddsUpdate& update) {
  for (const CellIndex cell : cells) {
    assert(box_.Contains(cell));
    CellValue& value = cells_[box_.FlatIndex(cell)];
    value = update(value);
  }
}

CellBox ProbabilityGrid::KnownBox() const {
  CellBox known;
  for (int row = 0; row < box_.height; ++row) {
    const auto begin = cells_.begin() + static_cast<std::ptrdiff_t>(row) * box_.width;
    const auto end = begin + box_.width;
    const auto is_known = [](CellValue value) { return value != kUnknown; };
    const auto first = std::find_if(begin, end, is_known);
    if (first == end) continue;
    const auto last =
        std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), is_known);
    const int left = static_cast<int>(first - begin);
    const int right = static_cast<int>(last.base() - begin);
    known = Union(known, {{box_.min.x + left, box_.min.y + row}, right - left, 1});
  }
  return known;
}

}  // namespace loopscope
