// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/block_sums.h"

#include <algorithm>

#include "core/grid/probability_grid.h"
#include "core/matching/precomputed_grids.h"

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/block_sums.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Sums of so many bytes fit into 16 bits.
constexpr std::size_t kMaxSummands = 257;

/// The sums of a row of blocks.
#if HWY_TARGET == HWY_SCALAR
class RowSums {
 public:
  void Add(const std::uint8_t* entries) {
    for (int k = 0; k < kBlocksPerSide; ++k) sums_[k] += entries[k];
  }
  void AddTo(std::int32_t* totals) const {
    for (int k = 0; k < kBlocksPerSide; ++k) totals[k] += sums_[k];
  }

 private:
  std::int32_t sums_[kBlocksPerSide] = {};
};
#else
class RowSums {
 public:
  HWY_INLINE RowSums() : sums_(hn::Zero(Words())) {}
  HWY_INLINE void Add(const std::uint8_t* entries) {
    sums_ = hn::Add(sums_, hn::PromoteTo(Words(), hn::LoadU(Bytes(), entries)));
  }
  HWY_INLINE void AddTo(std::int32_t* totals) const {
    HWY_ALIGN std::uint16_t sums[kBlocksPerSide];
    hn::Store(sums_, Words(), sums);
    for (int k = 0; k < kBlocksPerSide; ++k) totals[k] += sums[k];
  }

 private:
  using Bytes = hn::FixedTag<std::uint8_t, kBlocksPerSide>;
  using Words = hn::FixedTag<std::uint16_t, kBlocksPerSide>;
  hn::Vec<Words> sums_;
};
#endif

template <int kNumRows>
void SumSomeRows(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                 CellIndex offset, BlockSums* totals) {
  RowSums sums[kNumRows];
  const int height = grid.height();
  const int stride = grid.stride();
  const std::ptrdiff_t row_step = static_cast<std::ptrdiff_t>(stride) * grid.row_length();
  const CellIndex origin{offset.x - grid.box().min.x, offset.y - grid.box().min.y};
  const int last_whole = grid.box().height - (kNumRows - 1) * stride;
  for (std::size_t i = 0; i < num_cells; ++i) {
    const int x = cells[i].x + origin.x;
    const int y = cells[i].y + origin.y;
    const int k = x >> height;
    if (k <= -kBlocksPerSide || k >= grid.strip_length()) continue;
    const int place = grid.strip_start(x & (stride - 1)) + k;
    if (y >= 0 && y < last_whole) {
      const std::uint8_t* entries = grid.row(y) + place;
#pragma GCC unroll 8  // keeps the sums in registers
      for (int j = 0; j < kNumRows; ++j) {
        sums[j].Add(entries);
        entries += row_step;
      }
      continue;
    }
#pragma GCC unroll 8
    for (int j = 0; j < kNumRows; ++j) {
      const int row = y + j * stride;
      if (row >= 0 && row < grid.box().height) sums[j].Add(grid.row(row) + place);
    }
  }
#pragma GCC unroll 8
  for (int j = 0; j < kNumRows; ++j) sums[j].AddTo(totals->data() + j * kBlocksPerSide);
}

void SumBlocksHere(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                   CellIndex offset, int num_rows, BlockSums* totals) {
  static constexpr decltype(&SumSomeRows<1>) kSumRows[kBlocksPerSide] = {
      SumSomeRows<1>, SumSomeRows<2>, SumSomeRows<3>, SumSomeRows<4>,
      SumSomeRows<5>, SumSomeRows<6>, SumSomeRows<7>, SumSomeRows<8>};
  for (std::size_t i = 0; i < num_cells; i += kMaxSummands) {
    kSumRows[num_rows - 1](grid, cells + i, std::min(kMaxSummands, num_cells - i), offset, totals);
  }
}

/// Adds the StepsAboveMin of the row of `num_shifts` cells that begins at each of `starts`.
void SumRowsHere(const CellValue* const* starts, std::size_t num_starts, std::size_t num_shifts,
                 std::uint32_t* sums) {
  std::size_t done = 0;
#if HWY_TARGET != HWY_SCALAR
  constexpr std::size_t kNumLanes = 4;
  const hn::FixedTag<CellValue, kNumLanes> values;
  const hn::FixedTag<std::uint32_t, kNumLanes> wide;
  const auto one = hn::Set(values, 1);
  for (; done + kNumLanes <= num_shifts; done += kNumLanes) {
    auto sum = hn::Zero(wide);
    for (std::size_t i = 0; i < num_starts; ++i) {
      const auto value = hn::LoadU(values, starts[i] + done);
      sum = hn::Add(sum, hn::PromoteTo(wide, hn::SaturatedSub(value, one)));
    }
    hn::StoreU(sum, wide, sums + done);
  }
#endif
  for (; done < num_shifts; ++done) {
    std::uint32_t sum = 0;
    for (std::size_t i = 0; i < num_starts; ++i) {
      sum += StepsAboveMin(starts[i][done]);
    }
    sums[done] = sum;
  }
}

void MaximaOfShiftedHere(std::uint8_t* values, std::size_t shift, std::size_t count) {
  const hn::ScalableTag<std::uint8_t> bytes;
  const std::size_t num_lanes = hn::Lanes(bytes);
  std::size_t i = 0;
  for (; i + num_lanes <= count; i += num_lanes) {
    const auto shifted = hn::LoadU(bytes, values + i + shift);
    hn::StoreU(hn::Max(hn::LoadU(bytes, values + i), shifted), bytes, values + i);
  }
  for (; i < count; ++i) values[i] = std::max(values[i], values[i + shift]);
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

static_assert(PrecomputedGrid::kMargin >= kBlocksPerSide, "loads may begin so far outside");

HWY_EXPORT(SumBlocksHere);
HWY_EXPORT(SumRowsHere);
HWY_EXPORT(MaximaOfShiftedHere);

BlockSums SumBlocks(const PrecomputedGrid& grid, const std::vector<CellIndex>& cells,
                    CellIndex offset, int num_rows) {
  BlockSums totals{};
  HWY_DYNAMIC_DISPATCH(SumBlocksHere)
  (grid, cells.data(), cells.size(), offset, num_rows, &totals);
  return totals;
}

std::vector<std::uint32_t> SumShifted(const ProbabilityGrid& grid,
                                      const std::vector<CellIndex>& cells, int radius) {
  const int side = 2 * radius + 1;
  const CellBox& box = grid.box();
  std::vector<std::uint32_t> sums(static_cast<std::size_t>(side) * side, 0);
  std::vector<const CellValue*> starts;  // of points whose whole window is known
  starts.reserve(cells.size());
  for (const CellIndex cell : cells) {
    const CellIndex low{cell.x - radius, cell.y - radius};
    if (box.Contains(low) && box.Contains({cell.x + radius, cell.y + radius})) {
      starts.push_back(grid.cells().data() + box.FlatIndex(low));
      continue;
    }
    for (int k = 0; k < side * side; ++k) {
      sums[k] += StepsAboveMin(grid.value({low.x + k % side, low.y + k / side}));
    }
  }
  std::vector<std::uint32_t> row(side);
  for (int y = 0; y < side; ++y) {
    HWY_DYNAMIC_DISPATCH(SumRowsHere)(starts.data(), starts.size(), row.size(), row.data());
    for (int x = 0; x < side; ++x) sums[y * side + x] += row[x];
    for (const CellValue*& start : starts) start += box.width;
  }
  return sums;
}

void MaximaOfShifted(std::uint8_t* values, std::size_t shift, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(MaximaOfShiftedHere)(values, shift, count);
}

}  // namespace loopscope
#endif
