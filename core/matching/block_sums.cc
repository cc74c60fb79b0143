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

constexpr int kLogStripWidth = 4;
static_assert(1 << kLogStripWidth == PrecomputedGrid::kStripWidth);

/// Sums of so many bytes fit into 16 bits.
constexpr std::size_t kMaxSummands = 257;

#if HWY_TARGET != HWY_SCALAR
/// Stores the lanes of `values` that `is_wanted` names, one after the other, and returns how many.
template <typename Vec, typename Mask>
std::size_t StoreSome(Vec values, Mask is_wanted, std::int32_t* to) {
  const hn::DFromV<Vec> ints;
#if HWY_TARGET <= HWY_AVX3
  return hn::CompressStore(values, is_wanted, ints, to);
#else
  // CompressStore of Highway 1.0.3 copies a table of a kilobyte each time, as GCC 12 compiles it.
  HWY_ALIGN std::int32_t lanes[hn::MaxLanes(ints)];
  HWY_ALIGN std::int32_t lane_is_wanted[hn::MaxLanes(ints)];
  hn::Store(values, ints, lanes);
  hn::Store(hn::VecFromMask(ints, is_wanted), ints, lane_is_wanted);
  std::size_t count = 0;
  for (std::size_t lane = 0; lane < hn::Lanes(ints); ++lane) {
    to[count] = lanes[lane];
    count += lane_is_wanted[lane] & 1;
  }
  return count;
#endif
}
#endif

/// Where the windows of 8 x 8 entries of `grid` begin that the blocks see of the cells; none for
/// those that see only zeros. `places` has room for a vector more.
std::size_t FindWindows(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                        CellIndex offset, std::int32_t* places) {
  const CellIndex origin{offset.x - grid.box().min.x, offset.y - grid.box().min.y};
  std::size_t num_windows = 0;
#if HWY_TARGET == HWY_SCALAR
  for (std::size_t i = 0; i < num_cells; ++i) {
    const int x = cells[i].x + origin.x;
    const int y = cells[i].y + origin.y;
    const int column = x >> grid.height();
    const int row = y >> grid.height();
    if (column <= -kBlocksPerSide || column >= grid.num_columns()) continue;
    if (row <= -kBlocksPerSide || row >= grid.num_rows()) continue;
    places[num_windows++] = static_cast<std::int32_t>(
        grid.PlaceOf(x & (grid.stride() - 1), y & (grid.stride() - 1), column, row));
  }
#else
  const hn::ScalableTag<std::int32_t> ints;
  const auto height = grid.height();
  const auto last_phase = hn::Set(ints, grid.stride() - 1);
  const auto outside = hn::Set(ints, -kBlocksPerSide);
  const std::size_t num_lanes = hn::Lanes(ints);
  const std::size_t num_rest = num_cells % num_lanes;
  CellIndex rest[hn::MaxLanes(ints)] = {};
  std::copy(cells + num_cells - num_rest, cells + num_cells, rest);
  for (std::size_t i = 0; i < num_cells; i += num_lanes) {
    const std::size_t count = std::min(num_lanes, num_cells - i);
    const CellIndex* const of_vector = count == num_lanes ? cells + i : rest;
    hn::Vec<decltype(ints)> x;
    hn::Vec<decltype(ints)> y;
    hn::LoadInterleaved2(ints, &of_vector->x, x, y);
    x = hn::Add(x, hn::Set(ints, origin.x));
    y = hn::Add(y, hn::Set(ints, origin.y));
    const auto column = hn::ShiftRightSame(x, height);
    const auto row = hn::ShiftRightSame(y, height);
    const auto is_inside =
        hn::And(hn::And(hn::Gt(column, outside), hn::Lt(column, hn::Set(ints, grid.num_columns()))),
                hn::And(hn::Gt(row, outside), hn::Lt(row, hn::Set(ints, grid.num_rows()))));
    const auto phase =
        hn::Add(hn::ShiftLeftSame(hn::And(y, last_phase), height), hn::And(x, last_phase));
    const auto strip = hn::Add(hn::Mul(phase, hn::Set(ints, grid.num_strips())),
                               hn::Add(hn::ShiftRight<3>(column), hn::Set(ints, 1)));
    const auto in_strip = hn::Add(hn::ShiftLeft<kLogStripWidth>(hn::Sub(row, outside)),
                                  hn::And(column, hn::Set(ints, PrecomputedGrid::kStripStep - 1)));
    const auto place = hn::Add(hn::Mul(strip, hn::Set(ints, grid.strip_size())), in_strip);
    const auto counts = hn::FirstN(ints, count);
    if (hn::AllTrue(ints, hn::Or(is_inside, hn::Not(counts)))) {
      hn::StoreU(place, ints, places + num_windows);
      num_windows += count;
    } else if (!hn::AllFalse(ints, is_inside)) {
      num_windows += StoreSome(place, hn::And(is_inside, counts), places + num_windows);
    }
  }
#endif
  return num_windows;
}

#if HWY_TARGET == HWY_SCALAR
constexpr int kVectorRows = 1;

/// Adds a row of each window; windows begin so far after `bytes`.
void SumRowsOfWindows(const std::uint8_t* bytes, const std::int32_t* windows,
                      std::size_t num_windows, std::int32_t* sums) {
  for (std::size_t i = 0; i < num_windows; ++i) {
    for (int k = 0; k < kBlocksPerSide; ++k) sums[k] += bytes[windows[i] + k];
  }
}
#else
using WindowBytes = hn::CappedTag<std::uint8_t, 4 * PrecomputedGrid::kStripWidth>;
constexpr int kVectorRows = hn::MaxLanes(WindowBytes()) / PrecomputedGrid::kStripWidth;

/// Adds kVectorRows rows of each window, in 16 bits. Windows begin so far after `bytes`.
///
/// Two windows are taken at once: the bytes a and b that they have of a block become a word
/// a + 256 b. Modulo 2^16 the words add up to A + 256 B, their upper bytes to B, which is all it
/// takes: A + B = (A + 256 B) - 255 B.
void SumRowsOfWindows(const std::uint8_t* bytes, const std::int32_t* windows,
                      std::size_t num_windows, std::int32_t* sums) {
  const hn::Repartition<std::uint16_t, WindowBytes> words;
  auto word_sums = hn::Zero(words);
  auto upper_sums = hn::Zero(words);
  const auto add = [&](auto first, auto second) HWY_ATTR {
    const auto pairs = hn::BitCast(words, hn::InterleaveLower(WindowBytes(), first, second));
    word_sums = hn::Add(word_sums, pairs);
    upper_sums = hn::Add(upper_sums, hn::ShiftRight<8>(pairs));
  };
  const auto rows_of = [&](std::size_t i)
                           HWY_ATTR { return hn::LoadU(WindowBytes(), bytes + windows[i]); };
  std::size_t i = 0;
  for (; i + 4 <= num_windows; i += 4) {
    add(rows_of(i), rows_of(i + 1));
    add(rows_of(i + 2), rows_of(i + 3));
  }
  for (; i + 2 <= num_windows; i += 2) add(rows_of(i), rows_of(i + 1));
  if (i < num_windows) add(rows_of(i), hn::Zero(WindowBytes()));
  const auto both = hn::Add(hn::Sub(word_sums, hn::ShiftLeft<8>(upper_sums)), upper_sums);
  HWY_ALIGN std::uint16_t totals[kVectorRows * kBlocksPerSide];
  hn::Store(both, words, totals);
  for (int k = 0; k < kVectorRows * kBlocksPerSide; ++k) sums[k] += totals[k];
}
#endif

void SumBlocksHere(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                   CellIndex offset, int num_rows, BlockSums* totals) {
  std::int32_t windows[kMaxSummands + HWY_MAX_BYTES / sizeof(std::int32_t)];
  for (std::size_t i = 0; i < num_cells; i += kMaxSummands) {
    const std::size_t num_windows =
        FindWindows(grid, cells + i, std::min(kMaxSummands, num_cells - i), offset, windows);
    for (int row = 0; row < num_rows; row += kVectorRows) {
      SumRowsOfWindows(grid.bytes() + row * PrecomputedGrid::kStripWidth, windows, num_windows,
                       totals->data() + row * kBlocksPerSide);
    }
  }
}

std::int32_t MaxOfBlocksHere(const std::int32_t* rows, int num_rows, int num_columns) {
#if HWY_TARGET == HWY_SCALAR
  std::int32_t greatest = rows[0];
  for (int k = 0; k < num_rows * kBlocksPerSide; ++k) {
    if (k % kBlocksPerSide < num_columns) greatest = std::max(greatest, rows[k]);
  }
  return greatest;
#else
  const hn::CappedTag<std::int32_t, kBlocksPerSide / 2> ints;
  const int num_lanes = static_cast<int>(hn::Lanes(ints));
  auto greatest = hn::Set(ints, rows[0]);
  for (int column = 0; column < num_columns; column += num_lanes) {
    auto of_columns = hn::LoadU(ints, rows + column);
    for (int row = 1; row < num_rows; ++row) {
      of_columns = hn::Max(of_columns, hn::LoadU(ints, rows + row * kBlocksPerSide + column));
    }
    const auto counts = hn::FirstN(ints, num_columns - column);
    greatest = hn::Max(greatest, hn::IfThenElse(counts, of_columns, greatest));
  }
  return hn::GetLane(hn::MaxOfLanes(ints, greatest));
#endif
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

void SplitEvenOddHere(const std::uint8_t* values, std::size_t count, std::uint8_t* even,
                      std::uint8_t* odd) {
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::ScalableTag<std::uint8_t> bytes;
  for (; i + hn::Lanes(bytes) <= count; i += hn::Lanes(bytes)) {
    hn::Vec<decltype(bytes)> evens;
    hn::Vec<decltype(bytes)> odds;
    hn::LoadInterleaved2(bytes, values + 2 * i, evens, odds);
    hn::StoreU(evens, bytes, even + i);
    hn::StoreU(odds, bytes, odd + i);
  }
#endif
  for (; i < count; ++i) {
    even[i] = values[2 * i];
    odd[i] = values[2 * i + 1];
  }
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

static_assert(PrecomputedGrid::kStripStep == kBlocksPerSide, "a strip holds the row of any window");

HWY_EXPORT(SumBlocksHere);
HWY_EXPORT(MaxOfBlocksHere);
HWY_EXPORT(MaximaOfShiftedHere);
HWY_EXPORT(SplitEvenOddHere);

BlockSums SumBlocks(const PrecomputedGrid& grid, const CellIndex* cells, std::size_t num_cells,
                    CellIndex offset, int num_rows) {
  BlockSums totals{};
  HWY_DYNAMIC_DISPATCH(SumBlocksHere)(grid, cells, num_cells, offset, num_rows, &totals);
  return totals;
}

std::int32_t MaxOfBlocks(const std::int32_t* first, int num_rows, int num_columns) {
  return HWY_DYNAMIC_DISPATCH(MaxOfBlocksHere)(first, num_rows, num_columns);
}

void MaximaOfShifted(std::uint8_t* values, std::size_t shift, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(MaximaOfShiftedHere)(values, shift, count);
}

void SplitEvenOdd(const std::uint8_t* values, std::size_t count, std::uint8_t* even,
                  std::uint8_t* odd) {
  HWY_DYNAMIC_DISPATCH(SplitEvenOddHere)(values, count, even, odd);
}

}  // namespace loopscope
#endif
