// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// M_precomp^h of eq. 17: entry (x, y) is the maximum of M_nearest over the 2^h x 2^h cells that
/// begin at (x, y), in 8 bits: 0 is kMinProbability (also where unknown), 255 is kMaxProbability.
///
/// Entries that are 2^h apart in x lie side by side in memory, so that the blocks of a row of the
/// search tree are one load (see SumBlocks): row y holds 2^h strips, strip p the entries of the
/// columns p, p + 2^h, p + 2 * 2^h, ...
class PrecomputedGrid {
 public:
  /// Zeros before and after each strip: a load of so many entries may begin this far outside.
  static constexpr int kMargin = 8;

  /// Height 0.
  explicit PrecomputedGrid(const ProbabilityGrid& grid);
  /// Any height, from that of height 0.
  PrecomputedGrid(const PrecomputedGrid& finest, int height);

  int height() const { return height_; }
  /// All cells with an entry above 0; it reaches 2^h - 1 cells lower than the known cells.
  const CellBox& box() const { return box_; }

  /// 0 outside of the box.
  std::uint8_t value(CellIndex cell) const {
    if (!box_.Contains(cell)) return 0;
    const int x = cell.x - box_.min.x;
    return row(cell.y - box_.min.y)[strip_start(x & (stride() - 1)) + (x >> height_)];
  }

  /// 2^h [cells].
  int stride() const { return 1 << height_; }
  int strip_length() const { return strip_length_; }
  /// Where strip `p` begins in a row.
  int strip_start(int p) const { return kMargin + p * (strip_length_ + kMargin); }
  /// Row `y` counts from the low border of the box.
  const std::uint8_t* row(int y) const {
    return values_.data() + static_cast<std::size_t>(y) * row_length_;
  }
  int row_length() const { return row_length_; }

 private:
  PrecomputedGrid(const CellBox& box, int height);
  std::uint8_t* mutable_row(int y) {
    return values_.data() + static_cast<std::size_t>(y) * row_length_;
  }

  CellBox box_;
  int height_;
  int strip_length_;
  int row_length_;
  std::vector<std::uint8_t> values_;
};

/// One grid for each height 0 ... depth - 1, made when it is first asked for. May be used by
/// several threads at once.
class PrecomputedGrids {
 public:
  PrecomputedGrids(const ProbabilityGrid& grid, int depth);

  double resolution() const { return resolution_; }
  int max_height() const { return static_cast<int>(coarser_.size()); }
  const PrecomputedGrid& at_height(int height) const;

  /// The mean probability that `sum` of 8-bit values over `num_points` stands for.
  static double MeanProbability(int sum, int num_points) {
    return kMinProbability + sum * ((kMaxProbability - kMinProbability) / 255.0) / num_points;
  }

 private:
  struct Coarser {
    std::once_flag made;
    std::unique_ptr<const PrecomputedGrid> grid;
  };

  double resolution_;
  PrecomputedGrid finest_;
  mutable std::vector<Coarser> coarser_;  ///< of heights 1, 2, ...
};

}  // namespace loopscope
