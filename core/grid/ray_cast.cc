// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/ray_cast.h"

#include <algorithm>
#include <cstdint>

#include "core/grid/wall_filling.h"

namespace loopscope {
namespace {

/// [cells] Leaves no gaps in a wall, whatever its direction.
constexpr double kStepsAlongWalls = 0.7;

/// Which cells of a box were seen already.
class Marks {
 public:
  explicit Marks(const CellBox& box) : box_(box), marked_(box.num_cells(), 0) {}

  /// Marks the cells `left` to `right` of a row, and adds those that were not marked before.
  void MarkRun(int row, int left, int right, std::vector<CellIndex>* added) {
    std::uint8_t* mark = marked_.data() + box_.FlatIndex({left, row});
    for (int x = left; x <= right; ++x, ++mark) {
      if (*mark == 0) added->push_back({x, row});
      *mark = 1;
    }
  }

 private:
  CellBox box_;
  std::vector<std::uint8_t> marked_;
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
  double enter_x = low.x();
  for (int row = first_row; row <= last_row; ++row) {
    const double leave_x = row == last_row ? high.x() : low.x() + slope * (row + 1 - low.y());
    visit(row, FloorToInt(std::min(enter_x, leave_x)), FloorToInt(std::max(enter_x, leave_x)));
    enter_x = leave_x;
  }
}

/// Holds every cell that a ray may cross, and one more all around against rounding.
CellBox BoxOfRays(const RangeData& data, double resolution) {
  std::vector<CellIndex> ends{CellOf(data.origin, resolution)};
  for (const Eigen::Vector2d& point : data.returns) ends.push_back(CellOf(point, resolution));
  for (const Eigen::Vector2d& point : data.misses) ends.push_back(CellOf(point, resolution));
  const CellBox box = BoxOf(ends);
  return {{box.min.x - 1, box.min.y - 1}, box.width + 2, box.height + 2};
}

}  // namespace

ScanCells CastRays(const RangeData& data, double resolution, double max_wall_gap) {
  ScanCells cells;
  Marks marks(BoxOfRays(data, resolution));
  const auto hit = [&](const Eigen::Vector2d& point) {
    const CellIndex cell = CellOf(point, resolution);
    marks.MarkRun(cell.y, cell.x, cell.x, &cells.hits);
  };
  const PointCloud walls = PointsBetween(data.returns, max_wall_gap, kStepsAlongWalls * resolution);
  std::for_each(data.returns.begin(), data.returns.end(), hit);
  std::for_each(walls.begin(), walls.end(), hit);
  const Eigen::Vector2d origin = ToPixelFrame(data.origin, resolution);
  const auto cast_to = [&](const Eigen::Vector2d& end) {
    ForEachCrossedRow(origin, ToPixelFrame(end, resolution), [&](int row, int left, int right) {
      marks.MarkRun(row, left, right, &cells.misses);
    });
  };
  std::for_each(data.returns.begin(), data.returns.end(), cast_to);
  std::for_each(data.misses.begin(), data.misses.end(), cast_to);
  return cells;
}

}  // namespace loopscope
