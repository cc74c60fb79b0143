// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include "core/grid/cell.h"
#include "core/grid/probability.h"

namespace loopscope {

/// M of the paper: the probability that a cell is occupied, for the cells of a box that grows. The
/// lattice is fixed to the frame of the submap; growing moves no cell.
class ProbabilityGrid {
 public:
  /// `resolution` r is the edge of a cell [m].
  explicit ProbabilityGrid(double resolution) : resolution_(resolution) {}

  /// `cells` are row-major over `box`, lowest y first.
  ProbabilityGrid(double resolution, const CellBox& box, std::vector<CellValue> cells)
      : resolution_(resolution), box_(box), cells_(std::move(cells)) {}

  double resolution() const { return resolution_; }
  /// Of a grid of scans the smallest that holds all known cells, see ScanInserter.
  const CellBox& box() const { return box_; }
  /// Row-major over box(), lowest y first.
  const std::vector<CellValue>& cells() const { return cells_; }

  /// kUnknown outside of the box.
  CellValue value(CellIndex cell) const {
    return box_.Contains(cell) ? cells_[box_.FlatIndex(cell)] : kUnknown;
  }
  bool known(CellIndex cell) const { return value(cell) != kUnknown; }
  /// In [0.1, 0.9]; kMinProbability where unknown, so that nothing is gained by leaving the map.
  double probability(CellIndex cell) const {
    const CellValue v = value(cell);
    return v == kUnknown ? kMinProbability : ProbabilityOf(v);
  }

  /// Makes room for `box`. Throws std::length_error if that has more than kMaxNumCells.
  void GrowToInclude(const CellBox& box);

  /// Applies one observation to each of `cells`, which the box must hold. They are on a lattice on
  /// which `origin` is this one's cell (0, 0).
  void Update(const std::vector<CellIndex>& cells, const OddsUpdate& update, CellIndex origin = {});

 private:
  double resolution_;
  CellBox box_;
  std::vector<CellValue> cells_;
};

}  // namespace loopscope
