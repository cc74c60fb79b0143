// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid/probability_grid.h"
#include "core/matching/branch_and_bound.h"

namespace loopscope {

// The paper's algorithms as they stand there, one number after the other: what the fast ones are
// tested against and compared with.

/// M_precomp^h of eq. 17 for h = 0 ... depth - 1, in 8 bits; each by a maximum that slides over the
/// rows, then over the columns, of the grid of height 0.
class PlainPrecomputedGrids {
 public:
  PlainPrecomputedGrids(const ProbabilityGrid& grid, int depth);

  int max_height() const { return static_cast<int>(grids_.size()) - 1; }
  /// 0 outside of the grid.
  int value(int height, CellIndex cell) const {
    const Level& level = grids_[height];
    return level.box.Contains(cell) ? level.values[level.box.FlatIndex(cell)] : 0;
  }

 private:
  struct Level {
    CellBox box;
    std::vector<std::uint8_t> values;
  };
  std::vector<Level> grids_;
};

/// Algorithm 3, scalar and depth first, four children a node. The winner; nothing if no pose of the
/// window scores more than `min_score`.
std::optional<SearchResult> PlainBranchAndBound(const PlainPrecomputedGrids& grids,
                                                const SearchWindow& window,
                                                const PointCloud& points_in_scan, double min_score);

}  // namespace loopscope
