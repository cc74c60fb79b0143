// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/cell.h"

#include <algorithm>

namespace loopscope {

bool operator==(const CellBox& a, const CellBox& b) {
  return a.min == b.min && a.width == b.width && a.height == b.height;
}

CellBox Union(const CellBox& a, const CellBox& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  const CellIndex min{std::min(a.min.x, b.min.x), std::min(a.min.y, b.min.y)};
  return {min, std::max(a.min.x + a.width, b.min.x + b.width) - min.x,
          std::max(a.min.y + a.height, b.min.y + b.height) - min.y};
}

CellBox Intersection(const CellBox& a, const CellBox& b) {
  const CellIndex min{std::max(a.min.x, b.min.x), std::max(a.min.y, b.min.y)};
  const CellBox both{min, std::min(a.min.x + a.width, b.min.x + b.width) - min.x,
                     std::min(a.min.y + a.height, b.min.y + b.height) - min.y};
  return both.empty() ? CellBox() : both;
}

CellBox BoxOf(const std::vector<CellIndex>& cells) {
  if (cells.empty()) return {};
  CellIndex low = cells.front();
  CellIndex high = low;
  for (const CellIndex cell : cells) {
    low = {std::min(low.x, cell.x), std::min(low.y, cell.y)};
    high = {std::max(high.x, cell.x), std::max(high.y, cell.y)};
  }
  return {low, high.x - low.x + 1, high.y - low.y + 1};
}

}  // namespace loopscope
