// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/map_image.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
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

Patch MakePatch(const PlacedGrid& placed, const Raster& raster) {
  Patch patch;
  patch.box = PixelsOf(placed, raster);
  if (patch.box.empty()) return {};
  patch.values.assign(patch.box.num_cells(), kUnknown);
  FillFromCells(placed, raster, raster.pixel_size / placed.grid->resolution() < M_SQRT2, &patch);
  return patch;
}

/// The cells beneath the middles of the pixels of a row, in fixed point: steps must be cheap, and
/// what is rounded away is less than a thousandth of a cell over the widest picture.
class CellWalk {
 public:
  /// From `first`, in cells from the corner of `box`, by `step` for each pixel.
  CellWalk(const Eigen::Vector2d& first, const Eigen::Vector2d& step, const CellBox& box)
      : x_(ToFixed(first.x())),
        y_(ToFixed(first.y())),
        step_x_(ToFixed(step.x())),
        step_y_(ToFixed(step.y())),
        width_(box.width),
        height_(box.height) {}

  /// Of the pixels from `begin` to `end`, those whose cells lie in the box: they follow each other.
  std::pair<int, int> Inside(int begin, int end) const {
    Clip(x_, step_x_, width_, &begin, &end);
    Clip(y_, step_y_, height_, &begin, &end);
    return {begin, std::max(begin, end)};
  }

  /// Calls visit(pixel, index of the cell, row-major in the box) for pixels inside.
  template <typename Visitor>
  void Visit(int begin, int end, const Visitor& visit) const {
    std::int64_t x = x_ + begin * step_x_;
    std::int64_t y = y_ + begin * step_y_;
    for (int pixel = begin; pixel < end; ++pixel, x += step_x_, y += step_y_) {
      visit(pixel, (y >> kFractionBits) * width_ + (x >> kFractionBits));
    }
  }

 private:
  static constexpr int kFractionBits = 32;

  static std::int64_t ToFixed(double value) {
    return std::llround(std::ldexp(value, kFractionBits));
  }

  /// Leaves the pixels at which `first + pixel * step` lies in [0, size).
  static void Clip(std::int64_t first, std::int64_t step, std::int64_t size, int* begin, int* end) {
    const std::int64_t beyond = size << kFractionBits;
    const auto is_inside = [&](int pixel) {
      const std::int64_t at = first + pixel * step;
      return 0 <= at && at < beyond;
    };
    if (step != 0) {
      const double enter = static_cast<double>(step > 0 ? -first : beyond - first) / step;
      const double leave = static_cast<double>(step > 0 ? beyond - first : -first) / step;
      // One pixel more on each side against rounding.
      *begin = static_cast<int>(std::max<double>(*begin, std::floor(enter) - 1.0));
      *end = static_cast<int>(std::min<double>(*end, std::ceil(leave) + 2.0));
    }
    while (*begin < *end && !is_inside(*begin)) ++*begin;
    while (*begin < *end && !is_inside(*end - 1)) --*end;
  }

  std::int64_t x_;
  std::int64_t y_;
  std::int64_t step_x_;
  std::int64_t step_y_;
  std::int64_t width_;
  std::int64_t height_;
};

bool AreSame(const PlacedGrid& a, const PlacedGrid& b) {
  return a.grid == b.grid && a.map_from_grid == b.map_from_grid;
}

bool AreSame(const Raster& a, const Raster& b) {
  return a.origin == b.origin && a.pixel_size == b.pixel_size && a.width == b.width &&
         a.height == b.height;
}

}  // namespace

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

  const Raster& raster() const { return raster_; }

  /// Adds grids from `first` to before `last`.
  void Add(const PlacedGrid* first, const PlacedGrid* last) {
    const int count = static_cast<int>(last - first);
    // Points no farther apart than a pixel's edge / sqrt(2) miss no pixel, and likewise with cells.
    const bool small_pixels = std::all_of(first, last, [&](const PlacedGrid& grid) {
      return raster_.pixel_size / grid.grid->resolution() < M_SQRT1_2;
    });
    if (small_pixels) {
      std::vector<CellBox> pixels(count);
      ParallelFor(count, [&](int i) { pixels[i] = PixelsOf(first[i], raster_); });
      for (const CellBox& box : pixels) box_ = Union(box_, box);
      constexpr int kRowsOfBand = 32;
      ParallelFor((raster_.height + kRowsOfBand - 1) / kRowsOfBand, [&](int band) {
        const CellBox rows{{0, band * kRowsOfBand}, raster_.width, kRowsOfBand};
        for (int i = 0; i < count; ++i) AddFromPixels(first[i], Intersection(pixels[i], rows));
      });
    } else {
      std::vector<Patch> patches(count);
      ParallelFor(count, [&](int i) { patches[i] = MakePatch(first[i], raster_); });
      for (const Patch& patch : patches) {
        AddPatch(patch);
        box_ = Union(box_, patch.box);
      }
    }
  }

  CellImage ToImage(const MapColors& colors) const {
    const std::vector<Color> table = ColorTable(colors);
    CellImage image(box_);
    for (int y = box_.min.y; y < box_.min.y + box_.height; ++y) {
      std::size_t i = static_cast<std::size_t>(y) * raster_.width + box_.min.x;
      for (int x = box_.min.x; x < box_.min.x + box_.width; ++x, ++i) {
        if (known_[i]) image.Set({x, y}, table[TableIndex(sums_[i])]);
      }
    }
    return image;
  }

 private:
  static constexpr int kTableSize = 1024;

  void AddPatch(const Patch& patch) {
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

  /// For small pixels: adds what the grid has beneath the middle of each of `pixels`.
  void AddFromPixels(const PlacedGrid& placed, const CellBox& pixels) {
    const ProbabilityGrid& grid = *placed.grid;
    const CellValue* const cells = grid.cells().data();
    float* const sums = sums_.data();
    std::uint8_t* const known = known_.data();
    // From pixels of the raster to cells of the grid.
    const Pose2 grid_from_map = placed.map_from_grid.Inverse();
    const double scale = raster_.pixel_size / grid.resolution();
    const Eigen::Matrix2d turn = scale * grid_from_map.RotationMatrix();
    const Eigen::Vector2d shift = (grid_from_map * raster_.origin) / grid.resolution() +
                                  Eigen::Vector2d(0.5 - grid.box().min.x, 0.5 - grid.box().min.y);
    for (int y = pixels.min.y; y < pixels.min.y + pixels.height; ++y) {
      const CellWalk walk(turn * Eigen::Vector2d(0.0, y) + shift, turn.col(0), grid.box());
      const auto [begin, end] = walk.Inside(pixels.min.x, pixels.min.x + pixels.width);
      const std::size_t row = static_cast<std::size_t>(y) * raster_.width;
      walk.Visit(begin, end, [&](int x, std::ptrdiff_t cell) {
        const CellValue value = cells[cell];
        if (value == kUnknown) return;
        sums[row + x] += log_odds_[value];
        known[row + x] = 1;
      });
    }
  }

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

  Raster raster_;
  CellBox box_;  // holds all pixels that are known
  std::vector<float> sums_;
  std::vector<std::uint8_t> known_;
  std::vector<float> log_odds_;  // by value; 0 for kUnknown
};

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

MapComposer::MapComposer() = default;

MapComposer::~MapComposer() = default;

CellImage MapComposer::Compose(const std::vector<PlacedGrid>& grids, const Raster& raster,
                               const MapColors& colors) {
  const PlacedGrid* const end = grids.data() + grids.size();
  if (!composed_) {
    composed_ = true;
    LogOddsSum all(raster);
    all.Add(grids.data(), end);
    return all.ToImage(colors);
  }
  constexpr std::size_t kMaxGrowing = 2;  // submaps into which scans are inserted
  const auto same = [](const PlacedGrid& a, const PlacedGrid& b) { return AreSame(a, b); };
  const bool goes_on = sum_ && AreSame(sum_->raster(), raster) && kept_.size() <= grids.size() &&
                       std::equal(kept_.begin(), kept_.end(), grids.begin(), same);
  if (!goes_on) {
    kept_.clear();
    sum_ = std::make_unique<LogOddsSum>(raster);
  }
  const PlacedGrid* const rest =
      grids.data() + std::max(kept_.size(), grids.size() - std::min(grids.size(), kMaxGrowing));
  sum_->Add(grids.data() + kept_.size(), rest);
  kept_.assign(grids.data(), rest);
  LogOddsSum all = *sum_;
  all.Add(rest, end);
  return all.ToImage(colors);
}

vtkSmartPointer<vtkActor> MapLayer(const std::vector<PlacedGrid>& grids, const Raster& raster,
                                   const MapColors& colors, MapComposer* composer) {
  return CellImageLayer(composer->Compose(grids, raster, colors), Pose2(raster.origin, 0.0),
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
