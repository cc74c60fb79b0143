// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/probability_grid.h"

#include <algorithm>
#include <cassert>

namespace loopscope {

void ProbabilityGrid::GrowToInclude(const CellBox& box) {
  const CellBox grown = Union(box_, box);
  if (grown == box_) return;
  RequireFits(grown, resolution_);
  std::vector<CellValue> cells(grown.num_cells(), kUnknown);
  for (int row = 0; row < box_.height; ++row) {
    const auto from = cells_.begin() + static_cast<std::ptrdiff_t>(row) * box_.width;
    std::copy(from, from + box_.width,
              cells.begin() + grown.FlatIndex({box_.min.x, box_.min.y + row}));
  }
  box_ = grown;
  cells_ = std::move(cells);
}

void ProbabilityGrid::Update(const std::vector<CellIndex>& cells, const OddsUpdate& update,
                             CellIndex origin) {
  CellBox box = box_;
  box.min = {box_.min.x + origin.x, box_.min.y + origin.y};
  for (const CellIndex cell : cells) {
    assert(box.Contains(cell));
    CellValue& value = cells_[box.FlatIndex(cell)];
    value = update(value);
  }
}

}  // namespace loopscope
