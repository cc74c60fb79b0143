// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/turned_scan.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/matching/search_lattice.h"

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/matching/turned_scan.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

static_assert(sizeof(CellIndex) == 2 * sizeof(std::int32_t) &&
              sizeof(Eigen::Vector2d) == 2 * sizeof(double));

/// [cells] Of a quotient, as far as a cell can be from the origin.
constexpr double kMaxRounding = 1e-6;

/// CellOf of the points, moved by `rotation` and `translation` [m] before. `x_in_cells` and
/// `y_in_cells` are those of the points. In single precision they are off by less than `max_error`
/// [cells] when they are turned, which matters next to the border of a cell only.
void CellsOfMovedHere(const PointCloud& points, const float* x_in_cells, const float* y_in_cells,
                      float max_error, const Eigen::Matrix2d& rotation,
                      const Eigen::Vector2d& translation, double resolution, CellIndex* cells) {
  const hn::ScalableTag<float> numbers;
  const hn::RebindToSigned<decltype(numbers)> ints;
  const Eigen::Vector2d moved_in_cells = translation / resolution;
  const CellIndex whole{FloorToInt(moved_in_cells.x()), FloorToInt(moved_in_cells.y())};
  const auto number = [numbers](double value)
                          HWY_ATTR { return hn::Set(numbers, static_cast<float>(value)); };
  const auto rest_x = number(moved_in_cells.x() - whole.x + 0.5);
  const auto rest_y = number(moved_in_cells.y() - whole.y + 0.5);
  const auto cosine = number(rotation(0, 0));
  const auto sine = number(rotation(1, 0));
  const auto is_near_border = [&](auto place) HWY_ATTR {
    const auto from_border = hn::Abs(hn::Sub(place, hn::Round(place)));
    return hn::Lt(from_border, hn::Set(numbers, max_error));
  };
  const auto set_exactly = [&](std::size_t first, std::size_t count) {
    for (std::size_t k = first; k < first + count; ++k) {
      cells[k] = CellOf(rotation * points[k] + translation, resolution);
    }
  };
  const std::size_t num_lanes = hn::Lanes(numbers);
  if (points.size() < num_lanes) return set_exactly(0, points.size());
  for (std::size_t next = 0; next < points.size(); next += num_lanes) {
    const std::size_t i = std::min(next, points.size() - num_lanes);  // some at the end twice
    const auto x = hn::LoadU(numbers, x_in_cells + i);
    const auto y = hn::LoadU(numbers, y_in_cells + i);
    const auto place_x = hn::NegMulAdd(sine, y, hn::MulAdd(cosine, x, rest_x));
    const auto place_y = hn::MulAdd(cosine, y, hn::MulAdd(sine, x, rest_y));
    if (!hn::AllFalse(numbers, hn::Or(is_near_border(place_x), is_near_border(place_y)))) {
      set_exactly(i, num_lanes);
      continue;
    }
    const auto cell_x = hn::ConvertTo(ints, hn::Floor(place_x));
    const auto cell_y = hn::ConvertTo(ints, hn::Floor(place_y));
    hn::StoreInterleaved2(hn::Add(cell_x, hn::Set(ints, whole.x)),
                          hn::Add(cell_y, hn::Set(ints, whole.y)), ints, &cells[i].x);
  }
}

/// No cell is higher, in x or in y, than those of the point moved by either rotation, and then by
/// `translation` [m]; nor lower by more than one.
void LowestCellsHere(const Eigen::Vector2d* points, std::size_t num_points,
                     const Eigen::Matrix2d& first_rotation, const Eigen::Matrix2d& last_rotation,
                     const Eigen::Vector2d& translation, double resolution, CellIndex* cells) {
  const hn::ScalableTag<double> numbers;
  const hn::Rebind<std::int32_t, decltype(numbers)> indices;
  const auto inverse = hn::Set(numbers, 1.0 / resolution);
  std::size_t i = 0;
  for (; i + hn::Lanes(numbers) <= num_points; i += hn::Lanes(numbers)) {
    hn::Vec<decltype(numbers)> x;
    hn::Vec<decltype(numbers)> y;
    hn::LoadInterleaved2(numbers, points[i].data(), x, y);
    const auto coordinate = [&](int row) HWY_ATTR {
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
    hn::StoreInterleaved2(coordinate(0), coordinate(1), indices, &cells[i].x);
  }
  for (; i < num_points; ++i) {
    const Eigen::Vector2d lower =
        (first_rotation * points[i]).cwiseMin(last_rotation * points[i]) + translation;
    const Eigen::Vector2d in_cells = lower * (1.0 / resolution);
    cells[i] = {FloorToInt(in_cells.x() + (0.5 - kMaxRounding)),
                FloorToInt(in_cells.y() + (0.5 - kMaxRounding))};
  }
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {
namespace {

/// [cells] Of the farthest point, which an angular step moves by one cell.
double MaxRange(const SearchWindow& window) { return 0.5 / std::sin(0.5 * window.angular_step); }

/// [cells] At most so far off is a point when it is turned in single precision: eight roundings at
/// most, each by half of an epsilon.
float MaxErrorOfTurned(const SearchWindow& window) {
  constexpr float kEpsilon = std::numeric_limits<float>::epsilon();
  return 4.0F * kEpsilon * static_cast<float>(MaxRange(window) + 1.0);
}

}  // namespace

HWY_EXPORT(CellsOfMovedHere);
HWY_EXPORT(LowestCellsHere);

TurnedScan::TurnedScan(const SearchWindow& window, const PointCloud& points_in_scan)
    : window_(window),
      points_(points_in_scan),
      x_in_cells_(points_.size()),
      y_in_cells_(points_.size()),
      max_error_(MaxErrorOfTurned(window)) {
  const double cells_per_meter = 1.0 / window.resolution;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    x_in_cells_[i] = static_cast<float>(cells_per_meter * points_[i].x());
    y_in_cells_[i] = static_cast<float>(cells_per_meter * points_[i].y());
  }
}

std::vector<CellIndex> TurnedScan::CellsAt(int angle_index) const {
  std::vector<CellIndex> cells(points_.size());
  CellsAt(angle_index, cells.data());
  return cells;
}

void TurnedScan::CellsAt(int angle_index, CellIndex* cells) const {
  const Pose2 submap_from_scan = PoseInWindow(window_, {0, 0}, angle_index);
  HWY_DYNAMIC_DISPATCH(CellsOfMovedHere)
  (points_, x_in_cells_.data(), y_in_cells_.data(), max_error_, submap_from_scan.RotationMatrix(),
   submap_from_scan.translation, window_.resolution, cells);
}

std::vector<CellIndex> TurnedScan::LowestCells(int first_angle, int last_angle) const {
  // Each point moves on an arc; no farther than this from the line between its ends.
  const double half_turn = 0.5 * (last_angle - first_angle) * window_.angular_step;
  const double max_sagitta = MaxRange(window_) * window_.resolution * (1.0 - std::cos(half_turn));
  const Pose2 first = PoseInWindow(window_, {0, 0}, first_angle);
  const Pose2 last = PoseInWindow(window_, {0, 0}, last_angle);
  const Eigen::Vector2d lowest = first.translation.array() - max_sagitta;
  std::vector<CellIndex> cells(points_.size());
  HWY_DYNAMIC_DISPATCH(LowestCellsHere)
  (points_.data(), points_.size(), first.RotationMatrix(), last.RotationMatrix(), lowest,
   window_.resolution, cells.data());
  return cells;
}

}  // namespace loopscope
#endif
