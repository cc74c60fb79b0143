// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// M_precomp^h of eq. 17: entry (x, y) is the maximum of M_nearest over the 2^h x 2^h cells that
/// begin at (x, y), in 8 bits: 0 is kMinProbability (also where unknown), 255 is kMaxProbability.
class PrecomputedGrid {
 public:
  /// Height 0.
  explicit PrecomputedGrid(const ProbabilityGrid& grid);

  /// The grid of the next height, from the four blocks that make a block of it.
  PrecomputedGrid Coarser() const;

  int height() const { return height_; }
  /// All cells with an entry above 0; it reaches 2^h - 1 cells lower than the known cells.
  const CellBox& box() const { return box_; }

  /// 0 outside of the box.
  std::uint8_t value(CellIndex cell) const {
    const auto column = static_cast<unsigned>(cell.x - box_.min.x);
    const auto row = static_cast<unsigned>(cell.y - box_.min.y);
    if (column >= static_cast<unsigned>(box_.width) || row >= static_cast<unsigned>(box_.height)) {
      return 0;
    }
    return values_[static_cast<std::size_t>(row) * box_.width + column];
  }

 private:
  PrecomputedGrid() = default;

  int height_ = 0;
  CellBox box_;
  std::vector<std::uint8_t> values_;
};

/// One grid for each height 0 ... depth - 1.
class PrecomputedGrids {
 public:
  PrecomputedGrids(const ProbabilityGrid& grid, int depth);

  double resolution() const { return resolution_; }
  int max_height() const { return static_cast<int>(grids_.size()) - 1; }
  const PrecomputedGrid& at_height(int height) const { return grids_[height]; }

  /// The mean probability that `sum` of 8-bit values over `num_points` stands for.
  static double MeanProbability(int sum, int num_points) {
    return kMinProbability + sum * ((kMaxProbability - kMinProbability) / 255.0) / num_points;
  }

 private:
  double resolution_;
  std::vector<PrecomputedGrid> grids_;
};

}  // namespace loopscope
