// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/wide_walls.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/wide_walls.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Lanes = hn::ScalableTag<CellValue>;
using OneLane = hn::CappedTag<CellValue, 1>;

constexpr CellValue kLeastOfWall = (kMaxCellValue + 1) / 2;
constexpr CellValue kFree = 1;  // kMinProbability, but known

template <typename Tag>
void FindWallsAt(std::size_t x, const CellValue* below, const CellValue* here,
                 const CellValue* above, CellValue* walls, CellValue* highest) {
  const Tag tag;
  const auto is_wall = [&](auto value) { return hn::Gt(value, hn::Set(tag, kLeastOfWall - 1)); };
  const auto middle = hn::LoadU(tag, here + x);
  const auto beside = hn::Max(hn::LoadU(tag, below + x), hn::LoadU(tag, above + x));
  const auto free = hn::Min(middle, hn::Set(tag, kFree));
  hn::StoreU(hn::IfThenElse(is_wall(middle), middle, free), tag, walls + x);
  const auto all = hn::Max(middle, beside);
  hn::StoreU(hn::IfThenElseZero(is_wall(all), all), tag, highest + x);
}

/// The walls of row `here`, other cells free or unknown, and the highest wall of each column of
/// three rows.
void FindWalls(const CellValue* below, const CellValue* here, const CellValue* above,
               std::size_t width, CellValue* walls, CellValue* highest) {
  std::size_t x = 0;
  for (; x + hn::Lanes(Lanes()) <= width; x += hn::Lanes(Lanes())) {
    FindWallsAt<Lanes>(x, below, here, above, walls, highest);
  }
  for (; x < width; ++x) FindWallsAt<OneLane>(x, below, here, above, walls, highest);
}

template <typename Tag>
void WidenAt(std::size_t x, const CellValue* walls, const CellValue* highest, CellValue half_share,
             CellValue* wide) {
  const Tag tag;
  const auto sides = hn::Max(hn::LoadU(tag, highest + x), hn::LoadU(tag, highest + x + 2));
  const auto around = hn::Max(sides, hn::LoadU(tag, highest + x + 1));
  // The upper halves of the products, of which all bits but the highest are used.
  const auto beside = hn::MulHigh(hn::Add(around, around), hn::Set(tag, half_share));
  hn::StoreU(hn::Max(hn::LoadU(tag, walls + x), beside), tag, wide + x);
}

/// wide[x] is the higher of walls[x] and of a share of the highest of highest[x], ... [x + 2].
void Widen(const CellValue* walls, const CellValue* highest, std::size_t width,
           CellValue half_share, CellValue* wide) {
  std::size_t x = 0;
  for (; x + hn::Lanes(Lanes()) <= width; x += hn::Lanes(Lanes())) {
    WidenAt<Lanes>(x, walls, highest, half_share, wide);
  }
  for (; x < width; ++x) WidenAt<OneLane>(x, walls, highest, half_share, wide);
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {
namespace {

HWY_EXPORT(FindWalls);
HWY_EXPORT(Widen);

}  // namespace

ProbabilityGrid WithWideWalls(const ProbabilityGrid& grid, double share_beside) {
  assert(share_beside >= 0.0 && share_beside <= 1.0);
  const CellBox& box = grid.box();
  if (box.empty()) return grid;
  const auto half_share = static_cast<CellValue>(std::lround(share_beside * (1 << 15)));
  const CellBox wider{{box.min.x - 1, box.min.y - 1}, box.width + 2, box.height + 2};
  std::vector<CellValue> cells(wider.num_cells());
  const std::vector<CellValue> no_row(box.width, kUnknown);
  const auto row_of_grid = [&](int y) {
    return y < 0 || y >= box.height
               ? no_row.data()
               : grid.cells().data() + static_cast<std::ptrdiff_t>(y) * box.width;
  };
  // From one column left of the wider box on to one right of it.
  std::vector<CellValue> walls(wider.width + 2, kUnknown);
  std::vector<CellValue> highest(wider.width + 2, kUnknown);
  for (int y = 0; y < wider.height; ++y) {
    HWY_DYNAMIC_DISPATCH(FindWalls)
    (row_of_grid(y - 2), row_of_grid(y - 1), row_of_grid(y), box.width, walls.data() + 2,
     highest.data() + 2);
    HWY_DYNAMIC_DISPATCH(Widen)
    (walls.data() + 1, highest.data(), wider.width, half_share,
     cells.data() + static_cast<std::ptrdiff_t>(y) * wider.width);
  }
  return ProbabilityGrid(grid.resolution(), wider, std::move(cells));
}

}  // namespace loopscope
#endif  // HWY_ONCE
