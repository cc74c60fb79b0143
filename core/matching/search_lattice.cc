// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/search_lattice.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/search_lattice.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// [cells] Of a quotient, as far as a cell can be from the origin.
constexpr double kMaxRounding = 1e-6;

/// Sets the cells of points as long as they fill a vector, from what `coordinate` (0 for x, 1 for
/// y) makes of them. The number of these points.
template <typename Coordinate>
std::size_t CellsOfVectors(const Eigen::Vector2d* points, std::size_t num_points,
                           const Coordinate& coordinate, CellIndex* cells) {
  const hn::ScalableTag<double> numbers;
  const hn::Rebind<std::int32_t, decltype(numbers)> indices;
  static_assert(sizeof(CellIndex) == 2 * sizeof(std::int32_t) &&
                sizeof(Eigen::Vector2d) == 2 * sizeof(double));
  std::size_t i = 0;
  for (; i + hn::Lanes(numbers) <= num_points; i += hn::Lanes(numbers)) {
    hn::Vec<decltype(numbers)> x;
    hn::Vec<decltype(numbers)> y;
    hn::LoadInterleaved2(numbers, points[i].data(), x, y);
    hn::StoreInterleaved2(coordinate(0, x, y), coordinate(1, x, y), indices, &cells[i].x);
  }
  return i;
}

/// CellOf of many points, moved by `rotation` and `translation` [m] before.
void CellsOfMovedHere(const Eigen::Vector2d* points, std::size_t num_points,
                      const Eigen::Matrix2d& rotation, const Eigen::Vector2d& translation,
                      double resolution, CellIndex* cells) {
  const hn::ScalableTag<double> numbers;
  const hn::Rebind<std::int32_t, decltype(numbers)> indices;
  const auto r = hn::Set(numbers, resolution);
  const auto inverse = hn::Set(numbers, 1.0 / resolution);
  const auto half = hn::Set(numbers, 0.5);
  const auto coordinate = [&](int row, auto x, auto y) HWY_ATTR {
    const auto turned = hn::Add(hn::Mul(hn::Set(numbers, rotation(row, 0)), x),
                                hn::Mul(hn::Set(numbers, rotation(row, 1)), y));
    const auto moved = hn::Add(turned, hn::Set(numbers, translation[row]));
    // A division takes as long as all the rest. The product rounds otherwise, which matters next to
    // the border of a pixel only.
    const auto product = hn::Add(hn::Mul(moved, inverse), half);
    const auto from_border = hn::Abs(hn::Sub(product, hn::Round(product)));
    const auto cell = hn::AllFalse(numbers, hn::Lt(from_border, hn::Set(numbers, kMaxRounding)))
                          ? hn::Floor(product)
                          : hn::Floor(hn::Add(hn::Div(moved, r), half));
    return hn::DemoteTo(indices, cell);
  };
  std::size_t i = CellsOfVectors(points, num_points, coordinate, cells);
  for (; i < num_points; ++i) cells[i] = CellOf(rotation * points[i] + translation, resolution);
}

/// No cell is higher, in x or in y, than those of the point moved by either rotation, and then by
/// `translation` [m]; nor lower by more than one.
void LowestCellsHere(const Eigen::Vector2d* points, std::size_t num_points,
                     const Eigen::Matrix2d& first_rotation, const Eigen::Matrix2d& last_rotation,
                     const Eigen::Vector2d& translation, double resolution, CellIndex* cells) {
  const hn::ScalableTag<double> numbers;
  const hn::Rebind<std::int32_t, decltype(numbers)> indices;
  const auto inverse = hn::Set(numbers, 1.0 / resolution);
  const auto coordinate = [&](int row, auto x, auto y) HWY_ATTR {
    const auto turned = [&](const Eigen::Matrix2d& rotation) HWY_ATTR {
      return hn::Add(hn::Mul(hn::Set(numbers, rotation(row, 0)), x),
                     hn::Mul(hn::Set(numbers, rotation(row, 1)), y));
    };
    const auto lower = hn::Min(turned(first_rotation), turned(last_rotation));
    const auto moved = hn::Add(lower, hn::Set(numbers, translation[row]));
    const auto cell =
        hn::Floor(hn::Add(hn::Mul(moved, inverse), hn::Set(numbers, 0.5 - kMaxRounding)));
    return hn::DemoteTo(indices, cell);
  };
  std::size_t i = CellsOfVectors(points, num_points, coordinate, cells);
  for (; i < num_points; ++i) {
    const Eigen::Vector2d lower =
        (first_rotation * points[i]).cwiseMin(last_rotation * points[i]) + translation;
    cells[i] = {FloorToInt(lower.x() / resolution + 0.5 - kMaxRounding),
                FloorToInt(lower.y() / resolution + 0.5 - kMaxRounding)};
  }
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

HWY_EXPORT(CellsOfMovedHere);
HWY_EXPORT(LowestCellsHere);

double AngularStep(const PointCloud& points_in_scan, double resolution) {
  // A scan all of whose points are within a few cells has no use for larger steps.
  double max_range = 3.0 * resolution;
  for (const Eigen::Vector2d& point : points_in_scan) {
    max_range = std::max(max_range, point.norm());
  }
  const double ratio = resolution / max_range;
  return std::acos(1.0 - 0.5 * ratio * ratio);
}

SearchWindow MakeSearchWindow(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                              double linear_window, double angular_window, double resolution) {
  SearchWindow window;
  window.submap_from_scan_guess = submap_from_scan_guess;
  window.resolution = resolution;
  window.angular_step = AngularStep(points_in_scan, resolution);
  window.num_linear_steps = static_cast<int>(std::ceil(linear_window / resolution));
  window.num_angular_steps = static_cast<int>(std::ceil(angular_window / window.angular_step));
  return window;
}

Pose2 PoseInWindow(const SearchWindow& window, CellIndex offset, int angle_index) {
  const Pose2& guess = window.submap_from_scan_guess;
  return Pose2(guess.translation + CenterOf(offset, window.resolution),
               NormalizeAngle(guess.rotation + angle_index * window.angular_step));
}

std::vector<CellIndex> CellsAtAngle(const SearchWindow& window, const PointCloud& points_in_scan,
                                    int angle_index) {
  std::vector<CellIndex> cells(points_in_scan.size());
  CellsAtAngle(window, points_in_scan, angle_index, cells.data());
  return cells;
}

void CellsAtAngle(const SearchWindow& window, const PointCloud& points_in_scan, int angle_index,
                  CellIndex* cells) {
  const Pose2 submap_from_scan = PoseInWindow(window, {0, 0}, angle_index);
  HWY_DYNAMIC_DISPATCH(CellsOfMovedHere)
  (points_in_scan.data(), points_in_scan.size(), submap_from_scan.RotationMatrix(),
   submap_from_scan.translation, window.resolution, cells);
}

std::vector<CellIndex> LowestCells(const SearchWindow& window, const PointCloud& points_in_scan,
                                   int first_angle, int last_angle) {
  // Each point moves on an arc; no farther than this from the line between its ends. A step moves
  // the farthest point by one cell.
  const double max_range = 0.5 * window.resolution / std::sin(0.5 * window.angular_step);
  const double half_turn = 0.5 * (last_angle - first_angle) * window.angular_step;
  const double max_sagitta = max_range * (1.0 - std::cos(half_turn));
  const Pose2 first = PoseInWindow(window, {0, 0}, first_angle);
  const Pose2 last = PoseInWindow(window, {0, 0}, last_angle);
  const Eigen::Vector2d lowest = first.translation.array() - max_sagitta;
  std::vector<CellIndex> cells(points_in_scan.size());
  HWY_DYNAMIC_DISPATCH(LowestCellsHere)
  (points_in_scan.data(), points_in_scan.size(), first.RotationMatrix(), last.RotationMatrix(),
   lowest, window.resolution, cells.data());
  return cells;
}

}  // namespace loopscope
#endif
