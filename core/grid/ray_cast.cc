// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/ray_cast.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/grid/wall_filling.h"

namespace loopscope {
namespace {

/// [cells] Leaves no gaps in a wall, whatever its direction.
constexpr double kStepsAlongWalls = 0.7;

/// A set of cells of a box, a bit for each: a ray sets a row of cells at once.
class CellSet {
 public:
  explicit CellSet(const CellBox& box)
      : box_(box),
        words_per_row_((box.width + kBits - 1) / kBits),
        words_(static_cast<std::size_t>(words_per_row_) * box.height, 0) {}

  /// Whether the cell was not in it.
  bool Insert(CellIndex cell) {
    const int x = cell.x - box_.min.x;
    std::uint64_t& word = RowOf(cell.y)[x / kBits];
    const std::uint64_t bit = std::uint64_t{1} << (x % kBits);
    const bool is_new = (word & bit) == 0;
    word |= bit;
    return is_new;
  }

  /// The cells `left` to `right` of a row.
  void InsertRun(int row, int left, int right) {
    std::uint64_t* const words = RowOf(row);
    const int first = left - box_.min.x;
    const int last = right - box_.min.x;
    const std::uint64_t from_first = ~std::uint64_t{0} << (first % kBits);
    const std::uint64_t to_last = ~std::uint64_t{0} >> (kBits - 1 - last % kBits);
    const int first_word = first / kBits;
    const int last_word = last / kBits;
    if (first_word == last_word) {
      words[first_word] |= from_first & to_last;
      return;
    }
    words[first_word] |= from_first;
    std::fill(words + first_word + 1, words + last_word, ~std::uint64_t{0});
    words[last_word] |= to_last;
  }

  /// The smallest box around this set and `others`, a set of the same box.
  CellBox UnionBox(const CellSet& others) const {
    std::vector<std::uint64_t> columns(words_per_row_, 0);
    int bottom = box_.height;
    int top = -1;
    std::size_t i = 0;
    for (int y = 0; y < box_.height; ++y) {
      std::uint64_t any = 0;
      for (std::uint64_t& word : columns) {
        const std::uint64_t both = words_[i] | others.words_[i];
        word |= both;
        any |= both;
        ++i;
      }
      if (any == 0) continue;
      bottom = std::min(bottom, y);
      top = y;
    }
    if (top < 0) return {};
    const auto used = [](std::uint64_t word) { return word != 0; };
    const auto first = std::find_if(columns.begin(), columns.end(), used);
    const auto last = std::find_if(columns.rbegin(), columns.rend(), used).base() - 1;
    const int left = static_cast<int>(first - columns.begin()) * kBits + __builtin_ctzll(*first);
    const int right =
        static_cast<int>(last - columns.begin()) * kBits + kBits - 1 - __builtin_clzll(*last);
    return {{box_.min.x + left, box_.min.y + bottom}, right - left + 1, top - bottom + 1};
  }

  /// Those that are not in `others`, a set of the same box: row by row, from the lowest y on.
  std::vector<CellIndex> Without(const CellSet& others) const {
    std::vector<std::uint64_t> rest(words_.size());
    int count = 0;
    for (std::size_t i = 0; i < words_.size(); ++i) {
      rest[i] = words_[i] & ~others.words_[i];
      count += __builtin_popcountll(rest[i]);
    }
    std::vector<CellIndex> cells(count);
    CellIndex* cell = cells.data();
    auto word = rest.begin();
    for (int y = box_.min.y; y < box_.min.y + box_.height; ++y) {
      for (int i = 0; i < words_per_row_; ++i, ++word) {
        const int x = box_.min.x + i * kBits;
        for (; *word != 0; *word &= *word - 1) *cell++ = {x + __builtin_ctzll(*word), y};
      }
    }
    return cells;
  }

 private:
  static constexpr int kBits = 64;

  std::uint64_t* RowOf(int y) {
    return words_.data() + static_cast<std::size_t>(y - box_.min.y) * words_per_row_;
  }

  CellBox box_;
  int words_per_row_;
  std::vector<std::uint64_t> words_;
};

/// In units of cells, with pixels from whole number to whole number.
Eigen::Vector2d ToPixelFrame(const Eigen::Vector2d& point, double resolution) {
  return point / resolution + Eigen::Vector2d(0.5, 0.5);
}

/// Calls `visit(row, left, right)` for the cells that the segment from `a` to `b` (pixel frame)
/// crosses: within a row these are all between the places where the segment enters and leaves it.
template <typename Visitor>
void ForEachCrossedRow(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Visitor& visit) {
  const Eigen::Vector2d& low = a.y() <= b.y() ? a : b;
  const Eigen::Vector2d& high = a.y() <= b.y() ? b : a;
  const int first_row = FloorToInt(low.y());
  const int last_row = FloorToInt(high.y());
  const double slope = last_row > first_row ? (high.x() - low.x()) / (high.y() - low.y()) : 0.0;
  int enter = FloorToInt(low.x());
  for (int row = first_row; row <= last_row; ++row) {
    const int leave =
        FloorToInt(row == last_row ? high.x() : low.x() + slope * (row + 1 - low.y()));
    visit(row, std::min(enter, leave), std::max(enter, leave));
    enter = leave;
  }
}

Eigen::AlignedBox2d ExtentOf(const RangeData& data) {
  Eigen::AlignedBox2d extent(data.origin);
  for (const Eigen::Vector2d& point : data.returns) extent.extend(point);
  for (const Eigen::Vector2d& point : data.misses) extent.extend(point);
  return extent;
}

}  // namespace

CellBox BoxOfRays(const Eigen::AlignedBox2d& extent, double resolution,
                  std::int64_t max_num_cells) {
  if (extent.isEmpty()) return {};
  const CellBox cells = BoxOf(extent, resolution);
  const CellBox box{{cells.min.x - 1, cells.min.y - 1}, cells.width + 2, cells.height + 2};
  RequireFits(box, resolution, max_num_cells);
  return box;
}

ScanCells CastRays(const RangeData& data, double resolution, double max_wall_gap) {
  const CellBox box = BoxOfRays(ExtentOf(data), resolution);
  ScanCells cells;
  CellSet hits(box);
  const auto hit = [&](const Eigen::Vector2d& point) {
    const CellIndex cell = CellOf(point, resolution);
    if (hits.Insert(cell)) cells.hits.push_back(cell);
  };
  const PointCloud walls = PointsBetween(data.returns, max_wall_gap, kStepsAlongWalls * resolution);
  std::for_each(data.returns.begin(), data.returns.end(), hit);
  std::for_each(walls.begin(), walls.end(), hit);
  CellSet crossed(box);
  const Eigen::Vector2d origin = ToPixelFrame(data.origin, resolution);
  const auto cast_to = [&](const Eigen::Vector2d& end) {
    ForEachCrossedRow(origin, ToPixelFrame(end, resolution),
                      [&](int row, int left, int right) { crossed.InsertRun(row, left, right); });
  };
  std::for_each(data.returns.begin(), data.returns.end(), cast_to);
  std::for_each(data.misses.begin(), data.misses.end(), cast_to);
  cells.box = crossed.UnionBox(hits);
  cells.misses = crossed.Without(hits);
  return cells;
}

}  // namespace loopscope
