// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/shifted_sums.h"

#include <algorithm>
#include <vector>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/shifted_sums.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

#if HWY_TARGET == HWY_SCALAR
void AddWindowsHere(const Windows& windows, int side, std::uint32_t* sums) {
  for (std::size_t i = 0; i < windows.count; ++i) {
    for (int y = 0; y < side; ++y) {
      const CellValue* const row = windows.cells + windows.starts[i] + y * windows.width;
      for (int x = 0; x < side; ++x) sums[y * side + x] += StepsAboveMin(row[x]);
    }
  }
}
#else
/// Adds rows `first_row` to `first_row` + kRows - 1 of all windows.
template <int kRows>
void AddRows(const Windows& windows, int first_row, int side, std::uint32_t* sums) {
  const hn::CappedTag<std::uint32_t, kCellsPerLoad> wide;
  const hn::Rebind<CellValue, decltype(wide)> values;
  const auto one = hn::Set(values, 1);
  const int num_lanes = static_cast<int>(hn::Lanes(wide));
  for (int column = 0; column < side; column += num_lanes) {
    const CellValue* const first = windows.cells + first_row * windows.width + column;
    hn::Vec<decltype(wide)> totals[kRows];
    for (int row = 0; row < kRows; ++row) totals[row] = hn::Zero(wide);
    for (std::size_t i = 0; i < windows.count; ++i) {
      const CellValue* const of_window = first + windows.starts[i];
      for (int row = 0; row < kRows; ++row) {
        const auto value = hn::LoadU(values, of_window + row * windows.width);
        totals[row] = hn::Add(totals[row], hn::PromoteTo(wide, hn::SaturatedSub(value, one)));
      }
    }
    for (int row = 0; row < kRows; ++row) {
      HWY_ALIGN std::uint32_t lanes[kCellsPerLoad];
      hn::Store(totals[row], wide, lanes);
      std::uint32_t* const of_row = sums + (first_row + row) * side + column;
      for (int k = 0; k < std::min(num_lanes, side - column); ++k) of_row[k] += lanes[k];
    }
  }
}

void AddWindowsHere(const Windows& windows, int side, std::uint32_t* sums) {
  constexpr int kRowsAtOnce = 5;  // of a window of 0.1 m
  int row = 0;
  for (; row + kRowsAtOnce <= side; row += kRowsAtOnce) {
    AddRows<kRowsAtOnce>(windows, row, side, sums);
  }
  for (; row < side; ++row) AddRows<1>(windows, row, side, sums);
}
#endif

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {
namespace {

/// A window of which the grid has only a part.
void AddPartly(const ProbabilityGrid& grid, CellIndex low, int side, std::uint32_t* sums) {
  const CellBox window = Intersection(grid.box(), {low, side, side});
  for (int y = window.min.y; y < window.min.y + window.height; ++y) {
    const CellValue* const values = grid.cells().data() + grid.box().FlatIndex({window.min.x, y});
    std::uint32_t* const row = sums + (y - low.y) * side + (window.min.x - low.x);
    for (int x = 0; x < window.width; ++x) row[x] += StepsAboveMin(values[x]);
  }
}

}  // namespace

HWY_EXPORT(AddWindowsHere);

void AddShifted(const ProbabilityGrid& grid, const CellIndex* cells, std::size_t num_cells,
                int radius, std::uint32_t* sums) {
  const int side = 2 * radius + 1;
  const int read_width = (side + kCellsPerLoad - 1) / kCellsPerLoad * kCellsPerLoad;
  const CellBox& box = grid.box();
  const CellBox whole{box.min, box.width - read_width + 1, box.height - side + 1};
  std::vector<std::int32_t> starts;
  starts.reserve(num_cells);
  for (std::size_t i = 0; i < num_cells; ++i) {
    const CellIndex low{cells[i].x - radius, cells[i].y - radius};
    if (whole.Contains(low)) {
      starts.push_back(box.FlatIndex(low));
    } else {
      AddPartly(grid, low, side, sums);
    }
  }
  HWY_DYNAMIC_DISPATCH(AddWindowsHere)
  ({grid.cells().data(), box.width, starts.data(), starts.size()}, side, sums);
}

}  // namespace loopscope
#endif
