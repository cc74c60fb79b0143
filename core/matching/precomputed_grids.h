// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// M_precomp^h of eq. 17: entry (x, y) is the maximum of M_nearest over the 2^h x 2^h cells that
/// begin at (x, y), in 8 bits: 0 is kMinProbability (also where unknown), 255 is kMaxProbability.
///
/// Entries that are 2^h apart, in x and in y, make an image of their own, a phase; 4^h of them make
/// the grid. An image is stored in strips of 16 columns, each of which shares 8 with the next, one
/// row of 16 bytes after the other, with rows of zeros in between. So the 8 x 8 blocks of a square
/// of the search tree, wherever it begins, lie in 128 bytes in a row: two or three cache lines, see
/// SumBlocks.
class PrecomputedGrid {
 public:
  static constexpr int kStripWidth = 16;
  static constexpr int kStripStep = 8;

  /// Height 0.
  explicit PrecomputedGrid(const ProbabilityGrid& grid);
  /// Any height, from that of height 0. Entries are maxima over `sweep` cells more in x and in y;
  /// at most 2^height.
  PrecomputedGrid(const PrecomputedGrid& finest, int height, int sweep = 0);

  int height() const { return height_; }
  /// All cells with an entry above 0; it reaches 2^h - 1 + sweep cells lower than the known cells.
  const CellBox& box() const { return box_; }

  /// 0 outside of the box.
  std::uint8_t value(CellIndex cell) const {
    if (!box_.Contains(cell)) return 0;
    const int x = cell.x - box_.min.x;
    const int y = cell.y - box_.min.y;
    return bytes()[PlaceOf(x & (stride() - 1), y & (stride() - 1), x >> height_, y >> height_)];
  }

  /// 2^h [cells].
  int stride() const { return 1 << height_; }
  /// Of a phase; some of its entries may lie outside of the box, and are 0.
  int num_columns() const { return num_columns_; }
  int num_rows() const { return num_rows_; }
  int num_strips() const { return num_strips_; }
  /// From one strip to the next.
  int strip_size() const { return (num_rows_ + kStripStep) * kStripWidth; }

  /// Of all images. The first of a window of kStripStep rows and columns, whose rows are
  /// kStripWidth apart, is at PlaceOf; it may begin less than kStripStep outside of its phase.
  const std::uint8_t* bytes() const { return values_.data(); }
  std::size_t num_bytes() const { return values_.size(); }
  std::ptrdiff_t PlaceOf(int x_phase, int y_phase, int column, int row) const {
    // Strip 0 begins at column -kStripStep; so many rows of zeros stand before each.
    const std::ptrdiff_t phase = (static_cast<std::ptrdiff_t>(y_phase) << height_) + x_phase;
    return (phase * num_strips_ + (column >> 3) + 1) * strip_size() +
           (row + kStripStep) * kStripWidth + (column & (kStripStep - 1));
  }

 private:
  PrecomputedGrid(const CellBox& box, int height);
  /// Sets row `y` of the box to `line`, num_columns() entries for each phase; needs a buffer.
  void SetRow(int y, std::vector<std::uint8_t>* line, std::vector<std::uint8_t>* buffer);

  CellBox box_;
  int height_;
  int num_columns_;
  int num_rows_;
  int num_strips_;
  std::vector<std::uint8_t> values_;
};

/// One grid for each height 0 ... depth - 1, made when it is first asked for; each also with
/// maxima over 2^h cells more. May be used by several threads at once.
class PrecomputedGrids {
 public:
  PrecomputedGrids(const ProbabilityGrid& grid, int depth);

  double resolution() const { return resolution_; }
  int max_height() const { return static_cast<int>(coarser_.size()); }
  const PrecomputedGrid& at_height(int height) const;
  /// For points that are bounded at many angles at once: they sweep as many cells, see SectorQueue.
  const PrecomputedGrid& swept_at_height(int height) const;
  /// Of those made so far.
  std::size_t num_bytes() const { return num_bytes_; }

  /// The mean probability that `sum` of 8-bit values over `num_points` stands for.
  static double MeanProbability(int sum, int num_points) {
    return kMinProbability + sum * ((kMaxProbability - kMinProbability) / 255.0) / num_points;
  }

 private:
  struct Coarser {
    std::once_flag made;
    std::unique_ptr<const PrecomputedGrid> grid;
  };

  const PrecomputedGrid& Made(Coarser* coarser, int height, int sweep) const;

  double resolution_;
  PrecomputedGrid finest_;
  mutable std::vector<Coarser> coarser_;  ///< of heights 1, 2, ...
  mutable std::vector<Coarser> swept_;
  mutable std::atomic<std::size_t> num_bytes_;
};

}  // namespace loopscope
