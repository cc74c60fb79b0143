// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/bicubic_grid.h"

#include <cstddef>

namespace loopscope {
namespace {

/// Weights of the four neighbours -1, 0, 1, 2 at t in [0, 1) between 0 and 1.
Eigen::Array4d CubicWeights(double t) {
  const double t2 = t * t;
  const double t3 = t2 * t;
  return 0.5 * Eigen::Array4d(-t + 2.0 * t2 - t3, 2.0 - 5.0 * t2 + 3.0 * t3,
                              t + 4.0 * t2 - 3.0 * t3, -t2 + t3);
}

Eigen::Array4d CubicWeightDerivatives(double t) {
  const double t2 = t * t;
  return 0.5 * Eigen::Array4d(-1.0 + 4.0 * t - 3.0 * t2, -10.0 * t + 9.0 * t2,
                              1.0 + 8.0 * t - 9.0 * t2, -2.0 * t + 3.0 * t2);
}

/// What StepsAboveMin says of four cells side by side.
Eigen::Array4d RowOfFour(const CellValue* cells) {
  return Eigen::Array4i(StepsAboveMin(cells[0]), StepsAboveMin(cells[1]), StepsAboveMin(cells[2]),
                        StepsAboveMin(cells[3]))
      .cast<double>();
}

/// Likewise of the cells x ... x + 3 of row y, which the grid need not hold.
Eigen::Array4d RowOfFour(const ProbabilityGrid& grid, int x, int y) {
  const CellValue cells[] = {grid.value({x, y}), grid.value({x + 1, y}), grid.value({x + 2, y}),
                             grid.value({x + 3, y})};
  return RowOfFour(cells);
}

}  // namespace

SmoothValue BicubicGrid::At(const Eigen::Vector2d& point) const {
  const double u = point.x() / grid_.resolution();
  const double v = point.y() / grid_.resolution();
  const int x = FloorToInt(u);
  const int y = FloorToInt(v);
  const CellBox& box = grid_.box();
  const CellIndex low{x - 1, y - 1};
  const bool inside = box.Contains(low) && box.Contains({x + 2, y + 2});
  const CellValue* cells = inside ? grid_.cells().data() + box.FlatIndex(low) : nullptr;
  const Eigen::Array4d weights_x = CubicWeights(u - x);
  const Eigen::Array4d slopes_x = CubicWeightDerivatives(u - x);
  Eigen::Array4d values;
  Eigen::Array4d slopes;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Array4d row = inside
                                   ? RowOfFour(cells + static_cast<std::ptrdiff_t>(i) * box.width)
                                   : RowOfFour(grid_, low.x, low.y + i);
    values[i] = (row * weights_x).sum();
    slopes[i] = (row * slopes_x).sum();
  }
  const Eigen::Array4d weights_y = CubicWeights(v - y);
  const Eigen::Array4d slopes_y = CubicWeightDerivatives(v - y);
  return {kMinProbability + kProbabilityStep * (values * weights_y).sum(),
          kProbabilityStep / grid_.resolution() *
              Eigen::Vector2d((slopes * weights_y).sum(), (values * slopes_y).sum())};
}

}  // namespace loopscope
