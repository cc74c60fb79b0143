// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/precomputed_grids.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>

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

/// The box of the squares of 1 + `reach` cells that reach into `box`.
CellBox Lower(const CellBox& box, int reach) {
  if (box.empty()) return box;
  return {{box.min.x - reach, box.min.y - reach}, box.width + reach, box.height + reach};
}

/// Sorts a line by phase: first all entries whose column is 0 modulo 2^height, and so on, but
/// phases in the order of their bits reversed.
void SplitPhases(int height, std::vector<std::uint8_t>* line, std::vector<std::uint8_t>* buffer) {
  buffer->resize(line->size());
  for (int done = 0; done < height; ++done) {
    const std::size_t length = line->size() >> done;
    for (std::size_t begin = 0; begin < line->size(); begin += length) {
      std::uint8_t* const to = buffer->data() + begin;
      SplitEvenOdd(line->data() + begin, length / 2, to, to + length / 2);
    }
    line->swap(*buffer);
  }
}

int ReversedBits(int value, int num_bits) {
  int reversed = 0;
  for (int i = 0; i < num_bits; ++i) reversed |= ((value >> i) & 1) << (num_bits - 1 - i);
  return reversed;
}

/// Loads of whole vectors may read beyond the last entry.
constexpr int kSlack = 256;

/// Maxima of two values so far apart, one after the other, are maxima of 2^height + sweep values:
/// by doubling of 2, of 4, of 8, ...
std::vector<int> ShiftsOf(int height, int sweep) {
  std::vector<int> shifts;
  for (int half = 1; half < 1 << height; half *= 2) shifts.push_back(half);
  if (sweep > 0) shifts.push_back(sweep);
  return shifts;
}

/// Of each cell of `box`, which reaches `reach` cells lower than the finest grid, and of the
/// `reach` cells above it: the maximum along y, row by row. Below the low border of the grid stand
/// zeros.
std::vector<std::uint8_t> MaximaAlongY(const PrecomputedGrid& finest, const CellBox& box, int reach,
                                       const std::vector<int>& shifts) {
  const auto width = static_cast<std::size_t>(box.width);
  const auto num_rows = static_cast<std::size_t>(box.height + reach);
  std::vector<std::uint8_t> maxima(num_rows * width, 0);
  for (int y = 0; y < finest.box().height; ++y) {
    std::uint8_t* const to = maxima.data() + (y + reach) * width + reach;
    for (int x = 0; x < finest.box().width; x += PrecomputedGrid::kStripStep) {
      std::copy_n(finest.bytes() + finest.PlaceOf(0, 0, x, y),
                  std::min<int>(PrecomputedGrid::kStripStep, finest.box().width - x), to + x);
    }
  }
  for (const int shift : shifts) {
    MaximaOfShifted(maxima.data(), shift * width, (num_rows - shift) * width);
  }
  return maxima;
}

}  // namespace

PrecomputedGrid::PrecomputedGrid(const CellBox& box, int height)
    : box_(box),
      height_(height),
      num_columns_((box.width + stride() - 1) >> height),
      num_rows_((box.height + stride() - 1) >> height),
      num_strips_((num_columns_ + 2 * kStripStep - 1) / kStripStep),
      values_(PlaceOf(0, stride(), 0, 0) + kSlack, 0) {
  assert(values_.size() < std::numeric_limits<std::int32_t>::max());
}

PrecomputedGrid::PrecomputedGrid(const ProbabilityGrid& grid) : PrecomputedGrid(grid.box(), 0) {
  const ByteTable& bytes = Bytes();
  std::vector<std::uint8_t> line(box_.width);
  std::vector<std::uint8_t> buffer;
  for (int y = 0; y < box_.height; ++y) {
    const CellValue* from = grid.cells().data() + static_cast<std::ptrdiff_t>(y) * box_.width;
    for (int x = 0; x < box_.width; ++x) line[x] = bytes[from[x]];
    SetRow(y, &line, &buffer);
  }
}

PrecomputedGrid::PrecomputedGrid(const PrecomputedGrid& finest, int height, int sweep)
    : PrecomputedGrid(Lower(finest.box(), (1 << height) - 1 + sweep), height) {
  assert(sweep <= stride());
  // Eq. 17, first along y, then along x. The rows of a phase come one after the other.
  const int reach = stride() - 1 + sweep;
  const std::vector<int> shifts = ShiftsOf(height, sweep);
  const std::vector<std::uint8_t> maxima = MaximaAlongY(finest, box_, reach, shifts);
  std::vector<std::uint8_t> line;
  std::vector<std::uint8_t> buffer;
  for (int phase = 0; phase < stride(); ++phase) {
    for (int y = phase; y < box_.height; y += stride()) {
      line.assign(num_columns_ * stride() + reach, 0);
      std::copy_n(maxima.data() + static_cast<std::size_t>(y) * box_.width, box_.width,
                  line.data());
      for (const int shift : shifts) MaximaOfShifted(line.data(), shift, line.size() - shift);
      line.resize(num_columns_ * stride());
      SetRow(y, &line, &buffer);
    }
  }
}

void PrecomputedGrid::SetRow(int y, std::vector<std::uint8_t>* line,
                             std::vector<std::uint8_t>* buffer) {
  SplitPhases(height_, line, buffer);
  buffer->assign((num_strips_ + 1) * kStripStep, 0);
  for (int i = 0; i < stride(); ++i) {
    std::copy_n(line->data() + i * num_columns_, num_columns_, buffer->data() + kStripStep);
    const int x_phase = ReversedBits(i, height_);
    std::uint8_t* to =
        values_.data() + PlaceOf(x_phase, y & (stride() - 1), -kStripStep, y >> height_);
    for (int strip = 0; strip < num_strips_; ++strip, to += strip_size()) {
      std::copy_n(buffer->data() + strip * kStripStep, kStripWidth, to);
    }
  }
}

PrecomputedGrids::PrecomputedGrids(const ProbabilityGrid& grid, int depth)
    : resolution_(grid.resolution()),
      finest_(grid),
      coarser_(depth - 1),
      swept_(depth - 1),
      num_bytes_(finest_.num_bytes()) {}

const PrecomputedGrid& PrecomputedGrids::at_height(int height) const {
  return height == 0 ? finest_ : Made(&coarser_[height - 1], height, 0);
}

const PrecomputedGrid& PrecomputedGrids::swept_at_height(int height) const {
  return Made(&swept_[height - 1], height, 1 << height);
}

const PrecomputedGrid& PrecomputedGrids::Made(Coarser* coarser, int height, int sweep) const {
  std::call_once(coarser->made, [&] {
    coarser->grid = std::make_unique<const PrecomputedGrid>(finest_, height, sweep);
    num_bytes_ += coarser->grid->num_bytes();
  });
  return *coarser->grid;
}

}  // namespace loopscope
