// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/probability_grid.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.probability_grid_range_data_inserter.
struct ScanInserterOptions {
  double hit_probability = 0.55;   ///< above 0.5
  double miss_probability = 0.49;  ///< below 0.5
  bool insert_free_space = true;   ///< whether misses are written
  /// [m] Between neighbouring returns of one wall, up to which it is taken to go on; 0: never. Not
  /// in Cartographer.
  double max_wall_gap = 0.0;
};

/// Writes scans into grids (eqs. 2, 3).
class ScanInserter {
 public:
  explicit ScanInserter(const ScanInserterOptions& options);

  /// `cells` are on a lattice on which `origin` is the cell (0, 0) of `grid`, which grows as
  /// needed.
  void Insert(const ScanCells& cells, ProbabilityGrid* grid, CellIndex origin = {}) const;

 private:
  ScanInserterOptions options_;
  OddsUpdate hit_;
  OddsUpdate miss_;
};

}  // namespace loopscope
