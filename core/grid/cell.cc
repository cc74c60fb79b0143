// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/cell.h"

#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

namespace loopscope {

bool operator==(const CellBox& a, const CellBox& b) {
  return a.min == b.min && a.width == b.width && a.height == b.height;
}

void RequireFits(const CellBox& box, double resolution, std::int64_t max_num_cells) {
  if (box.empty() || box.num_cells() <= max_num_cells) return;
  throw std::length_error(
      fmt::format("a grid of {:.0f} m x {:.0f} m has more cells of {:g} m than fit in memory",
                  resolution * box.width, resolution * box.height, resolution));
}

CellBox BoxOf(const Eigen::AlignedBox2d& extent, double resolution) {
  if (extent.isEmpty()) return {};
  // The difference of two indices is an index, and so is that of two differences.
  constexpr double kMaxIndex = 2.5e8;
  const double farthest =
      std::max(extent.min().cwiseAbs().maxCoeff(), extent.max().cwiseAbs().maxCoeff());
  if (!extent.sizes().allFinite() || farthest > kMaxIndex * resolution) {
    throw std::length_error(
        fmt::format("a place is {:.3g} m from the origin: expected at most {:g} cells of {:g} m",
                    farthest, kMaxIndex, resolution));
  }
  const CellIndex min = CellOf(extent.min(), resolution);
  const CellIndex max = CellOf(extent.max(), resolution);
  return {min, max.x - min.x + 1, max.y - min.y + 1};
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
