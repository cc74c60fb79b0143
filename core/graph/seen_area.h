// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "core/grid/probability_grid.h"

namespace loopscope {

/// Where a submap has seen free space, in blocks of 4 x 4 cells. A scan that was taken elsewhere,
/// behind a wall say, can hardly match the submap.
class SeenArea {
 public:
  explicit SeenArea(const ProbabilityGrid& grid);

  /// [m] From `place` [m], in the frame of the submap, to the nearest block that was seen; 0 within
  /// it. Right to 4 % and half a block, and no more than 51 blocks plus the way to the known cells.
  double DistanceTo(const Eigen::Vector2d& place) const;

 private:
  std::uint8_t& at(int x, int y) { return distances_[static_cast<std::size_t>(y) * width_ + x]; }
  void MarkSeenBlocks(const ProbabilityGrid& grid);
  void SpreadDistances();

  double block_size_;  ///< [m]
  CellBox known_;
  int width_;                            ///< [blocks]
  int height_;                           ///< [blocks]
  std::vector<std::uint8_t> distances_;  ///< [1/5 block], by block, row-major
};

}  // namespace loopscope
