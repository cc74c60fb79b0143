// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/precomputed_grids.h"

#include <algorithm>
#include <array>

#include "core/matching/block_sums.h"

namespace loopscope {
namespace {

std::uint8_t ToByte(CellValue value) {
  if (value == kUnknown) return 0;
  return static_cast<std::uint8_t>((255 * (value - 1) + (kMaxCellValue - 1) / 2) /
                                   (kMaxCellValue - 1));
}

using ByteTable = std::array<std::uint8_t, kMaxCellValue + 1>;

const ByteTable& Bytes() {
  static const ByteTable table = [] {
    ByteTable made;
    for (int value = 0; value <= kMaxCellValue; ++value) {
      made[value] = ToByte(static_cast<CellValue>(value));
    }
    return made;
  }();
  return table;
}

/// The box of the blocks of 2^height cells that reach into `box`.
CellBox Lower(const CellBox& box, int height) {
  const int reach = (1 << height) - 1;
  if (box.empty()) return box;
  return {{box.min.x - reach, box.min.y - reach}, box.width + reach, box.height + reach};
}

}  // namespace

PrecomputedGrid::PrecomputedGrid(const CellBox& box, int height)
    : box_(box),
      height_(height),
      strip_length_((box.width + stride() - 1) >> height),
      row_length_(strip_start(stride())),
      values_(static_cast<std::size_t>(row_length_) * box.height, 0) {}

PrecomputedGrid::PrecomputedGrid(const ProbabilityGrid& grid)
    : PrecomputedGrid(grid.KnownBox(), 0) {
  const ByteTable& bytes = Bytes();
  for (int y = 0; y < box_.height; ++y) {
    const CellValue* from =
        grid.cells().data() + grid.box().FlatIndex({box_.min.x, box_.min.y + y});
    std::uint8_t* to = mutable_row(y) + strip_start(0);
    for (int x = 0; x < box_.width; ++x) to[x] = bytes[from[x]];
  }
}

PrecomputedGrid::PrecomputedGrid(const PrecomputedGrid& finest, int height)
    : PrecomputedGrid(Lower(finest.box(), height), height) {
  const int reach = stride() - 1;
  const int width = finest.box().width;
  // Maxima of `stride` rows, by doubling: of 1, of 2, of 4, ... Below the low border stand zeros.
  const int num_rows = box_.height;
  std::vector<std::uint8_t> columns(static_cast<std::size_t>(num_rows + reach) * width, 0);
  for (int y = 0; y < finest.box().height; ++y) {
    std::copy_n(finest.row(y) + finest.strip_start(0), width,
                columns.data() + static_cast<std::size_t>(y + reach) * width);
  }
  for (int half = 1; half < stride(); half *= 2) {
    MaximaOfShifted(columns.data(), static_cast<std::size_t>(half) * width,
                    static_cast<std::size_t>(num_rows + reach - half) * width);
  }
  // The same along each row, whose entries then go to their strips.
  const int padded_width = strip_length_ * stride();
  std::vector<std::uint8_t> line;
  for (int y = 0; y < num_rows; ++y) {
    line.assign(padded_width + reach, 0);
    std::copy_n(columns.data() + static_cast<std::size_t>(y) * width, width, line.data() + reach);
    for (int half = 1; half < stride(); half *= 2) {
      MaximaOfShifted(line.data(), half, line.size() - half);
    }
    for (int p = 0; p < stride(); ++p) {
      std::uint8_t* strip = mutable_row(y) + strip_start(p);
      for (int k = 0; k < strip_length_; ++k) strip[k] = line[(k << height_) + p];
    }
  }
}

PrecomputedGrids::PrecomputedGrids(const ProbabilityGrid& grid, int depth)
    : resolution_(grid.resolution()), finest_(grid), coarser_(depth - 1) {}

const PrecomputedGrid& PrecomputedGrids::at_height(int height) const {
  if (height == 0) return finest_;
  Coarser& coarser = coarser_[height - 1];
  std::call_once(coarser.made,
                 [&] { coarser.grid = std::make_unique<const PrecomputedGrid>(finest_, height); });
  return *coarser.grid;
}

}  // namespace loopscope
