// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <utility>

#include "core/sensor/range_data.h"

namespace loopscope {

/// A grid of the paper as it stands there: a probability for each cell that was observed, by eqs. 2
/// and 3, with sets of hits and misses that are found by walking each ray cell by cell (Amanatides,
/// Woo, "A Fast Voxel Traversal Algorithm for Ray Tracing", 1987).
class PlainGrid {
 public:
  using Cell = std::pair<int, int>;  ///< x, y

  explicit PlainGrid(double resolution) : resolution_(resolution) {}

  /// Inserts a scan in the frame of the grid.
  void Insert(const RangeData& data, double hit_probability, double miss_probability);

  const std::map<Cell, double>& probabilities() const { return probabilities_; }

 private:
  double resolution_;  // [m]
  std::map<Cell, double> probabilities_;
};

}  // namespace loopscope
