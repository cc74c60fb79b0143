// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/log_odds_sum.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "render/parallel.h"

namespace loopscope {
namespace {

constexpr int kTableSize = 1024;

/// By value; 0 for kUnknown.
const std::vector<float>& LogOddsTable() {
  static const std::vector<float> table = [] {
    std::vector<float> log_odds(kMaxCellValue + 1);
    for (int value = 1; value <= kMaxCellValue; ++value) {
      log_odds[value] = static_cast<float>(std::log(Odds(ProbabilityOf(value))));
    }
    return log_odds;
  }();
  return table;
}

/// Colours of log odds from certainly free to certainly occupied.
std::vector<Color> ColorTable(const MapColors& colors) {
  const double max_log_odds = std::log(Odds(kMaxProbability));
  std::vector<Color> table;
  for (int i = 0; i < kTableSize; ++i) {
    const double log_odds = max_log_odds * (2.0 * i / (kTableSize - 1) - 1.0);
    table.push_back(colors.At(ProbabilityFromOdds(std::exp(log_odds))));
  }
  return table;
}

int TableIndex(float log_odds, float max_log_odds) {
  const float share = 0.5f + 0.5f * log_odds / max_log_odds;
  return std::clamp(static_cast<int>(share * (kTableSize - 1) + 0.5f), 0, kTableSize - 1);
}

/// Calls work(box) for boxes that are `rows` of `area` each, several at a time.
template <typename Work>
void ForBandsOf(const CellBox& area, int rows, const Work& work) {
  ParallelFor((area.height + rows - 1) / rows, [&](int band) {
    work(Intersection(area, {{area.min.x, area.min.y + band * rows}, area.width, rows}));
  });
}

constexpr int kRowsAtOnce = 32;

/// Whether no cell is missed if the middle of each pixel is looked at: points no farther apart than
/// a pixel's edge / sqrt(2) miss no pixel, and likewise with cells.
bool ArePixelsSmall(const PlacedGrid* first, const PlacedGrid* last, const Raster& raster) {
  return std::all_of(first, last, [&](const PlacedGrid& grid) {
    return raster.pixel_size / grid.grid->resolution() < M_SQRT1_2;
  });
}

/// What one grid says about the pixels of a box of the raster.
struct Patch {
  CellBox box;
  std::vector<CellValue> values;  ///< row-major, kUnknown where the grid knows nothing
};

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

Patch MakePatch(const PlacedGrid& placed, const Raster& raster, const CellBox& area) {
  Patch patch;
  patch.box = Intersection(PixelsOf(placed, raster), area);
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

}  // namespace

Extent ExtentOf(const PlacedGrid& grid) {
  Extent extent;
  const CellBox& box = grid.grid->box();
  if (box.empty()) return extent;
  const CellIndex max{box.min.x + box.width - 1, box.min.y + box.height - 1};
  for (const CellIndex corner :
       {box.min, CellIndex{max.x, box.min.y}, max, CellIndex{box.min.x, max.y}}) {
    extent.extend(grid.map_from_grid * CenterOf(corner, grid.grid->resolution()));
  }
  return extent;
}

bool operator==(const Raster& a, const Raster& b) {
  return a.origin == b.origin && a.pixel_size == b.pixel_size && a.width == b.width &&
         a.height == b.height;
}

CellBox PixelsOf(const PlacedGrid& grid, const Raster& raster) {
  const Extent extent = ExtentOf(grid);
  if (extent.isEmpty()) return {};
  const CellIndex min = CellOf(extent.min() - raster.origin, raster.pixel_size);
  const CellIndex max = CellOf(extent.max() - raster.origin, raster.pixel_size);
  return Intersection({min, max.x - min.x + 1, max.y - min.y + 1},
                      {{0, 0}, raster.width, raster.height});
}

CellBox PixelsOf(const PlacedGrid* first, const PlacedGrid* last, const Raster& raster) {
  CellBox pixels;
  for (; first != last; ++first) pixels = Union(pixels, PixelsOf(*first, raster));
  return pixels;
}

CellImage LogOddsSum::PaintAll(const std::vector<PlacedGrid>& grids, const Raster& raster,
                               const MapColors& colors) {
  const PlacedGrid* const first = grids.data();
  const PlacedGrid* const last = first + grids.size();
  const CellBox area = PixelsOf(first, last, raster);
  CellImage image = CellImage::Unpainted(area);
  // Large pixels are found from the cells, of which each is looked at once for each band.
  const int rows = ArePixelsSmall(first, last, raster) ? kRowsAtOnce : std::max(area.height, 1);
  ForBandsOf(area, rows, [&](const CellBox& band) {
    LogOddsSum sum(raster, band);
    sum.Add(first, last);
    sum.Paint(band, colors, &image);
  });
  return image;
}

LogOddsSum::LogOddsSum(const Raster& raster)
    : LogOddsSum(raster, {{0, 0}, raster.width, raster.height}) {}

LogOddsSum::LogOddsSum(const Raster& raster, const CellBox& area)
    : raster_(raster),
      area_(area),
      sums_(static_cast<std::size_t>(area.width) * area.height),
      known_(sums_.size()) {}

std::size_t LogOddsSum::IndexOf(CellIndex pixel) const {
  return static_cast<std::size_t>(pixel.y - area_.min.y) * area_.width + (pixel.x - area_.min.x);
}

LogOddsSum LogOddsSum::PartOf(const CellBox& area) const {
  LogOddsSum part(raster_, area);
  part.known_box_ = Intersection(known_box_, area);
  for (int y = area.min.y; y < area.min.y + area.height; ++y) {
    const std::size_t from = IndexOf({area.min.x, y});
    const std::size_t to = part.IndexOf({area.min.x, y});
    std::copy_n(sums_.begin() + from, area.width, part.sums_.begin() + to);
    std::copy_n(known_.begin() + from, area.width, part.known_.begin() + to);
  }
  return part;
}

void LogOddsSum::Add(const PlacedGrid* first, const PlacedGrid* last) {
  ArePixelsSmall(first, last, raster_) ? AddPixels(first, last) : AddCells(first, last);
}

/// For small pixels: adds what the grids have beneath the middle of each.
void LogOddsSum::AddPixels(const PlacedGrid* first, const PlacedGrid* last) {
  std::vector<CellBox> pixels;
  for (const PlacedGrid* placed = first; placed != last; ++placed) {
    pixels.push_back(Intersection(PixelsOf(*placed, raster_), area_));
    known_box_ = Union(known_box_, pixels.back());
  }
  ForBandsOf(area_, kRowsAtOnce, [&](const CellBox& band) {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      AddPixelsOf(first[i], Intersection(pixels[i], band));
    }
  });
}

void LogOddsSum::AddPixelsOf(const PlacedGrid& placed, const CellBox& pixels) {
  const ProbabilityGrid& grid = *placed.grid;
  const CellValue* const cells = grid.cells().data();
  const float* const log_odds = LogOddsTable().data();
  // From pixels of the raster to cells of the grid.
  const Pose2 grid_from_map = placed.map_from_grid.Inverse();
  const double scale = raster_.pixel_size / grid.resolution();
  const Eigen::Matrix2d turn = scale * grid_from_map.RotationMatrix();
  const Eigen::Vector2d shift = (grid_from_map * raster_.origin) / grid.resolution() +
                                Eigen::Vector2d(0.5 - grid.box().min.x, 0.5 - grid.box().min.y);
  for (int y = pixels.min.y; y < pixels.min.y + pixels.height; ++y) {
    const CellWalk walk(turn * Eigen::Vector2d(0.0, y) + shift, turn.col(0), grid.box());
    const auto [begin, end] = walk.Inside(pixels.min.x, pixels.min.x + pixels.width);
    float* const sums = sums_.data() + IndexOf({area_.min.x, y});
    std::uint8_t* const known = known_.data() + IndexOf({area_.min.x, y});
    const int left = area_.min.x;
    walk.Visit(begin, end, [&](int x, std::ptrdiff_t cell) {
      const CellValue value = cells[cell];
      if (value == kUnknown) return;
      sums[x - left] += log_odds[value];
      known[x - left] = 1;
    });
  }
}

/// For large pixels: adds the highest odds of the cells in each.
void LogOddsSum::AddCells(const PlacedGrid* first, const PlacedGrid* last) {
  const float* const log_odds = LogOddsTable().data();
  std::vector<Patch> patches(last - first);
  ParallelFor(static_cast<int>(patches.size()),
              [&](int i) { patches[i] = MakePatch(first[i], raster_, area_); });
  for (const Patch& patch : patches) {
    auto value = patch.values.begin();
    for (int y = patch.box.min.y; y < patch.box.min.y + patch.box.height; ++y) {
      std::size_t i = IndexOf({patch.box.min.x, y});
      for (int x = 0; x < patch.box.width; ++x, ++i, ++value) {
        sums_[i] += log_odds[*value];
        known_[i] |= *value != kUnknown;
      }
    }
    known_box_ = Union(known_box_, patch.box);
  }
}

void LogOddsSum::Paint(const CellBox& area, const MapColors& colors, CellImage* image) const {
  const std::vector<Color> table = ColorTable(colors);
  const float max_log_odds = LogOddsTable().back();
  ForBandsOf(area, kRowsAtOnce, [&](const CellBox& band) {
    for (int y = band.min.y; y < band.min.y + band.height; ++y) {
      std::size_t i = IndexOf({band.min.x, y});
      for (int x = band.min.x; x < band.min.x + band.width; ++x, ++i) {
        image->Set({x, y},
                   known_[i] ? table[TableIndex(sums_[i], max_log_odds)] : Color{0, 0, 0, 0});
      }
    }
  });
}

}  // namespace loopscope
