// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid/cell.h"
#include "core/matching/search_trace.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// The cells of a scan at the angles of a search window. Since the window moves in whole cells,
/// they need only be shifted for every other pose of the angle. The same on any processor.
class TurnedScan {
 public:
  /// Keeps references to both.
  TurnedScan(const SearchWindow& window, const PointCloud& points_in_scan);

  /// Of the points at the guess turned by `angle_index` steps.
  std::vector<CellIndex> CellsAt(int angle_index) const;
  /// Likewise, into `cells`, which has room for a cell of each point.
  void CellsAt(int angle_index, CellIndex* cells) const;

  /// Whether LowestCells holds for so many angles: of a scan of less than 24 cells the arcs of more
  /// than 8 are so round that they may sweep a cell more.
  static bool HasLowestCells(const SearchWindow& window, int num_angles) {
    return num_angles <= 8 || window.angular_step < 1.0 / 24.0;
  }

  /// Lower bounds of the cells of each point, in x and in y, at all angles of the window from
  /// `first_angle` to `last_angle`, of which no cell is higher by more than last - first + 1.
  std::vector<CellIndex> LowestCells(int first_angle, int last_angle) const;

 private:
  const SearchWindow& window_;
  const PointCloud& points_;
  std::vector<float> x_in_cells_;
  std::vector<float> y_in_cells_;
  float max_error_ = 0.0F;  ///< [cells] of their places when they are turned in single precision
};

}  // namespace loopscope
