// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/grid/probability_grid.h"
#include "render/layers/cell_image.h"
#include "render/layers/grid_image.h"
#include "render/scene.h"

namespace loopscope {

/// A submap's grid and where it lies in the map.
struct PlacedGrid {
  std::shared_ptr<const ProbabilityGrid> grid;
  Pose2 map_from_grid;
};

/// Where the known cells of the grid lie in the map; empty if there are none.
Extent ExtentOf(const PlacedGrid& grid);

/// Pixels over a map: pixel (x, y) is a square around origin + size * (x, y).
struct Raster {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();  ///< [m]
  double pixel_size = 0.05;                          ///< [m]
  int width = 0;
  int height = 0;
};

bool operator==(const Raster& a, const Raster& b);

/// The pixels of the raster that known cells of `grid` may touch.
CellBox PixelsOf(const PlacedGrid& grid, const Raster& raster);

/// Holds the pixels of the raster that any grid from `first` to before `last` may touch, and those
/// between.
CellBox PixelsOf(const PlacedGrid* first, const PlacedGrid* last, const Raster& raster);

/// The log odds of grids for pixels of a raster, summed (eq. 3). A grid has the highest odds of its
/// known cells in a pixel.
class LogOddsSum {
 public:
  /// Nothing yet for all pixels of `raster`.
  explicit LogOddsSum(const Raster& raster);

  /// Paint for all pixels that any of `grids` may touch. Some rows after the others, so that the
  /// sums take little memory.
  static CellImage PaintAll(const std::vector<PlacedGrid>& grids, const Raster& raster,
                            const MapColors& colors);

  /// What this has for the pixels of `area`, which the raster must hold.
  LogOddsSum PartOf(const CellBox& area) const;

  const Raster& raster() const { return raster_; }
  /// Holds all pixels that a grid knows.
  const CellBox& known_box() const { return known_box_; }

  /// Adds grids from `first` to before `last`.
  void Add(const PlacedGrid* first, const PlacedGrid* last);

  /// Shows what is known of the pixels of `area`, and clears those of which nothing is. The image
  /// must hold them, and this the sums for them.
  void Paint(const CellBox& area, const MapColors& colors, CellImage* image) const;

 private:
  LogOddsSum(const Raster& raster, const CellBox& area);

  std::size_t IndexOf(CellIndex pixel) const;
  void AddPixels(const PlacedGrid* first, const PlacedGrid* last);
  void AddPixelsOf(const PlacedGrid& placed, const CellBox& pixels);
  void AddCells(const PlacedGrid* first, const PlacedGrid* last);

  Raster raster_;
  CellBox area_;  // pixels whose sums are here
  CellBox known_box_;
  std::vector<float> sums_;  // row-major over area_
  std::vector<std::uint8_t> known_;
};

}  // namespace loopscope
