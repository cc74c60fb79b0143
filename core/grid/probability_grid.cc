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
  const auto is_known = [](CellValue value) { return value != kUnknown; };
  const auto row_begin = [&](int row) {
    return cells_.begin() + static_cast<std::ptrdiff_t>(row) * box_.width;
  };
  const auto has_known = [&](int row) {
    return std::any_of(row_begin(row), row_begin(row + 1), is_known);
  };
  int bottom = 0;
  while (bottom < box_.height && !has_known(bottom)) ++bottom;
  if (bottom == box_.height) return {};
  int top = box_.height - 1;
  while (!has_known(top)) --top;
  // Of the rows between only what lies outside of the columns so far is looked at.
  int left = box_.width;
  int right = 0;
  for (int row = bottom; row <= top; ++row) {
    const auto begin = row_begin(row);
    left = static_cast<int>(std::find_if(begin, begin + left, is_known) - begin);
    const auto last_known = std::find_if(std::make_reverse_iterator(begin + box_.width),
                                         std::make_reverse_iterator(begin + right), is_known);
    right = static_cast<int>(last_known.base() - begin);
  }
  return {{box_.min.x + left, box_.min.y + bottom}, right - left, top - bottom + 1};
}

}  // namespace loopscope
