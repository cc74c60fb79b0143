// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid/cell.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// The whole map as one grid on a lattice that is fixed to the map frame, see CellIndex.
struct OccupancyMap {
  double resolution = 0.0;  ///< r [m]
  CellBox box;              ///< holds all rays; empty if there are none
  /// How likely each cell is occupied, in (0, 1), row-major over `box`, lowest y first; NaN where
  /// nothing is known.
  std::vector<float> probabilities;

  float probability(CellIndex cell) const { return probabilities[box.FlatIndex(cell)]; }
};

/// All scans that became nodes, cast once more from their optimized poses. Unlike submaps laid over
/// each other this turns no grid, so that walls are as thin as the poses are right. The odds of all
/// observations of a cell are multiplied (eq. 3 without clamp, hence in any order), with those of
/// OctoMap's sensor model (Hornung et al., Autonomous Robots 34, 2013): 0.7 for a hit, 0.4 for a
/// miss, which decides even on cells that were seen a few times only. Throws std::length_error if
/// poses are so far apart that the map would not fit in memory.
OccupancyMap BuildOccupancyMap(const Recording& recording, const MapState& state);

}  // namespace loopscope
