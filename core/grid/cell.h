// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/floor_to_int.h"

namespace loopscope {

/// A grid point k of the lattice rZ x rZ that is fixed to a submap's frame: it stands at r * (x, y)
/// and owns the pixel of all points nearest to it, [r (x - 1/2), r (x + 1/2)) x ... .
struct CellIndex {
  int x = 0;
  int y = 0;
};

inline bool operator==(CellIndex a, CellIndex b) { return a.x == b.x && a.y == b.y; }
inline bool operator!=(CellIndex a, CellIndex b) { return !(a == b); }

/// The cell whose pixel holds `point` [m].
inline CellIndex CellOf(const Eigen::Vector2d& point, double resolution) {
  return {FloorToInt(point.x() / resolution + 0.5), FloorToInt(point.y() / resolution + 0.5)};
}

/// Where the grid point stands [m].
inline Eigen::Vector2d CenterOf(CellIndex cell, double resolution) {
  return resolution * Eigen::Vector2d(cell.x, cell.y);
}

/// A rectangle of cells, [min.x, min.x + width) x [min.y, min.y + height).
struct CellBox {
  CellIndex min;
  int width = 0;
  int height = 0;

  bool Contains(CellIndex cell) const {
    return cell.x >= min.x && cell.x < min.x + width && cell.y >= min.y && cell.y < min.y + height;
  }
  bool empty() const { return width <= 0 || height <= 0; }
  int num_cells() const { return width * height; }
  /// Row-major place of a cell of the box.
  int FlatIndex(CellIndex cell) const { return (cell.y - min.y) * width + (cell.x - min.x); }
};

bool operator==(const CellBox& a, const CellBox& b);

/// The smallest box that holds both; an empty box holds nothing.
CellBox Union(const CellBox& a, const CellBox& b);

/// The cells that are in both; empty if there are none.
CellBox Intersection(const CellBox& a, const CellBox& b);

/// The smallest box that holds all of `cells`.
CellBox BoxOf(const std::vector<CellIndex>& cells);

/// The cells that a scan observed, each at most once: hits and misses are disjoint.
struct ScanCells {
  std::vector<CellIndex> hits;
  std::vector<CellIndex> misses;
  CellBox box;  ///< the smallest that holds them all
};

}  // namespace loopscope
