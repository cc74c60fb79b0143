// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

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

/// The cell whose pixel holds `point` [m], whose index must be one of an int.
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
  std::int64_t num_cells() const { return std::int64_t{width} * height; }
  /// Row-major place of a cell of the box.
  int FlatIndex(CellIndex cell) const { return (cell.y - min.y) * width + (cell.x - min.x); }
};

bool operator==(const CellBox& a, const CellBox& b);

/// More cells of a submap are a fault of the data, such as odometry that jumps by kilometres.
constexpr std::int64_t kMaxNumCells = std::int64_t{1} << 27;

/// Throws std::length_error if `box` has more cells, of edge `resolution` [m], than that.
void RequireFits(const CellBox& box, double resolution, std::int64_t max_num_cells = kMaxNumCells);

/// The cells whose pixels hold a point of `extent` [m]. Throws std::length_error if one is farther
/// than 2.5e8 cells from the origin.
CellBox BoxOf(const Eigen::AlignedBox2d& extent, double resolution);

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
