// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/map_image.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "render/parallel.h"

namespace loopscope {
namespace {

/// What one grid says about the pixels of a box of the raster.
struct Patch {
  CellBox box;
  std::vector<CellValue> values;  ///< row-major, kUnknown where the grid knows nothing
};

/// The pixels of the raster that `grid` may touch.
CellBox PixelsOf(const PlacedGrid& grid, const Raster& raster) {
  const Extent extent = ExtentOf(grid);
  if (extent.isEmpty()) return {};
  const CellIndex min = CellOf(extent.min() - raster.origin, raster.pixel_size);
  const CellIndex max = CellOf(extent.max() - raster.origin, raster.pixel_size);
  return Intersection({min, max.x - min.x + 1, max.y - min.y + 1},
                      {{0, 0}, raster.width, raster.height});
}

void Raise(CellIndex pixel, CellValue value, Patch* patch) {
  if (!patch->box.Contains(pixel)) return;
  CellValue& there = patch->values[patch->box.FlatIndex(pixel)];
  there = std::max(there, value);
}

/// Points of a cell, relative to its middle: the middle, or those of its four quarters [cells].
std::vector<Eigen::Vector2d> PointsOfCell(bool quarters) {
  if (!quarters) return {Eigen::Vector2d::Zero()};
  return {{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}};
}

/// For large pixels: drops every known cell into the pixels in which its points lie.
void FillFromCells(const PlacedGrid& placed, const Raster& raster, bool quarters, Patch* patch) {
  const ProbabilityGrid& grid = *placed.grid;
  const CellBox& box = grid.box();
  // From cells of the grid to pixels of the raster.
  const double scale = grid.resolution() / raster.pixel_size;
  const Eigen::Matrix2d turn = scale * placed.map_from_grid.RotationMatrix();
  const Eigen::Vector2d shift =
      (placed.map_from_grid.translation - raster.origin) / raster.pixel_size;
  for (const Eigen::Vector2d& point : PointsOfCell(quarters)) {
    auto value = grid.cells().begin();
    for (int y = 0; y < box.height; ++y) {
      const Eigen::Vector2d first(box.min.x + point.x(), box.min.y + y + point.y());
      Eigen::Vector2d pixel = turn * first + shift;
      for (int x = 0; x < box.width; ++x, ++value, pixel += turn.col(0)) {
        if (*value != kUnknown) Raise(CellOf(pixel, 1.0), *value, patch);
      }
    }
  }
}

/// For small pixels: looks up the cell beneath the middle of each.
void FillFromPixels(const PlacedGrid& placed, const Raster& raster, Patch* patch) {
  const ProbabilityGrid& grid = *placed.grid;
  // From pixels of the raster to cells of the grid.
  const Pose2 grid_from_map = placed.map_from_grid.Inverse();
  const double scale = raster.pixel_size / grid.resolution();
  const Eigen::Matrix2d turn = scale * grid_from_map.RotationMatrix();
  const Eigen::Vector2d shift = (grid_from_map * raster.origin) / grid.resolution();
  auto value = patch->values.begin();
  for (int y = 0; y < patch->box.height; ++y) {
    const Eigen::Vector2d first(patch->box.min.x, patch->box.min.y + y);
    Eigen::Vector2d cell = turn * first + shift;
    for (int x = 0; x < patch->box.width; ++x, ++value, cell += turn.col(0)) {
      *value = grid.value(CellOf(cell, 1.0));
    }
  }
}

Patch MakePatch(const PlacedGrid& placed, const Raster& raster) {
  Patch patch;
  patch.box = PixelsOf(placed, raster);
  if (patch.box.empty()) return {};
  patch.values.assign(patch.box.num_cells(), kUnknown);
  // Points no farther apart than a pixel's edge / sqrt(2) miss no pixel, and likewise with cells.
  const double cells_per_pixel = raster.pixel_size / placed.grid->resolution();
  if (cells_per_pixel < M_SQRT1_2) {
    FillFromPixels(placed, raster, &patch);
  } else {
    FillFromCells(placed, raster, cells_per_pixel < M_SQRT2, &patch);
  }
  return patch;
}

/// Sums of log odds, shown in colours of a table.
class LogOddsSum {
 public:
  explicit LogOddsSum(const Raster& raster)
      : raster_(raster),
        sums_(static_cast<std::size_t>(raster.width) * raster.height),
        known_(sums_.size()),
        log_odds_(kMaxCellValue + 1) {
    for (int value = 1; value <= kMaxCellValue; ++value) {
      log_odds_[value] = static_cast<float>(std::log(Odds(ProbabilityOf(value))));
    }
  }

  void Add(const Patch& patch) {
    for (int y = 0; y < patch.box.height; ++y) {
      const std::size_t row =
          static_cast<std::size_t>(patch.box.min.y + y) * raster_.width + patch.box.min.x;
      for (int x = 0; x < patch.box.width; ++x) {
        const CellValue value = patch.values[static_cast<std::size_t>(y) * patch.box.width + x];
        sums_[row + x] += log_odds_[value];
        known_[row + x] |= value != kUnknown;
      }
    }
  }

  CellImage ToImage(const MapColors& colors) const {
    const std::vector<Color> table = ColorTable(colors);
    CellImage image({{0, 0}, raster_.width, raster_.height});
    std::size_t i = 0;
    for (int y = 0; y < raster_.height; ++y) {
      for (int x = 0; x < raster_.width; ++x, ++i) {
        if (known_[i]) image.Set({x, y}, table[TableIndex(sums_[i])]);
      }
    }
    return image;
  }

 private:
  static constexpr int kTableSize = 1024;

  /// Colours of log odds from certainly free to certainly occupied.
  static std::vector<Color> ColorTable(const MapColors& colors) {
    const double max_log_odds = std::log(Odds(kMaxProbability));
    std::vector<Color> table;
    for (int i = 0; i < kTableSize; ++i) {
      const double log_odds = max_log_odds * (2.0 * i / (kTableSize - 1) - 1.0);
      table.push_back(colors.At(ProbabilityFromOdds(std::exp(log_odds))));
    }
    return table;
  }

  int TableIndex(float log_odds) const {
    const float share = 0.5f + 0.5f * log_odds / log_odds_.back();
    return std::clamp(static_cast<int>(share * (kTableSize - 1) + 0.5f), 0, kTableSize - 1);
  }

  const Raster& raster_;
  std::vector<float> sums_;
  std::vector<std::uint8_t> known_;
  std::vector<float> log_odds_;  // by value; 0 for kUnknown
};

}  // namespace

Raster RasterFor(const FlatCamera& camera, const Box& frame, double resolution) {
  Raster raster;
  raster.pixel_size = std::max(camera.meters_per_pixel, 0.5 * resolution);
  const Eigen::Vector2d size = camera.meters_per_pixel * Eigen::Vector2d(frame.width, frame.height);
  raster.width = static_cast<int>(std::ceil(size.x() / raster.pixel_size - 1e-6));
  raster.height = static_cast<int>(std::ceil(size.y() / raster.pixel_size - 1e-6));
  const double half = 0.5 * raster.pixel_size;
  raster.origin = camera.center - 0.5 * size + Eigen::Vector2d(half, half);
  return raster;
}

CellImage ComposeMap(const std::vector<PlacedGrid>& grids, const Raster& raster,
                     const MapColors& colors) {
  std::vector<Patch> patches(grids.size());
  ParallelFor(static_cast<int>(grids.size()),
              [&](int i) { patches[i] = MakePatch(grids[i], raster); });
  LogOddsSum sum(raster);
  for (const Patch& patch : patches) sum.Add(patch);
  return sum.ToImage(colors);
}

vtkSmartPointer<vtkActor> MapLayer(const std::vector<PlacedGrid>& grids, const Raster& raster,
                                   const MapColors& colors) {
  return CellImageLayer(ComposeMap(grids, raster, colors), Pose2(raster.origin, 0.0),
                        raster.pixel_size);
}

Extent ExtentOf(const PlacedGrid& grid) {
  Extent extent;
  const CellBox box = grid.grid->KnownBox();
  if (box.empty()) return extent;
  const CellIndex max{box.min.x + box.width - 1, box.min.y + box.height - 1};
  for (const CellIndex corner :
       {box.min, CellIndex{max.x, box.min.y}, max, CellIndex{box.min.x, max.y}}) {
    extent.extend(grid.map_from_grid * CenterOf(corner, grid.grid->resolution()));
  }
  return extent;
}

}  // namespace loopscope
