// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/bicubic_grid.h"

#include <cmath>

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

/// Probabilities of the cells x ... x + 3 of row y.
Eigen::Array4d RowOfFour(const ProbabilityGrid& grid, int x, int y) {
  return {grid.probability({x, y}), grid.probability({x + 1, y}), grid.probability({x + 2, y}),
          grid.probability({x + 3, y})};
}

}  // namespace

SmoothValue BicubicGrid::At(const Eigen::Vector2d& point) const {
  const double u = point.x() / grid_.resolution();
  const double v = point.y() / grid_.resolution();
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
  const Eigen::Array4d weights_x = CubicWeights(u - x);
  const Eigen::Array4d slopes_x = CubicWeightDerivatives(u - x);
  Eigen::Array4d values;
  Eigen::Array4d slopes;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Array4d row = RowOfFour(grid_, x - 1, y - 1 + i);
    values[i] = (row * weights_x).sum();
    slopes[i] = (row * slopes_x).sum();
  }
  const Eigen::Array4d weights_y = CubicWeights(v - y);
  const Eigen::Array4d slopes_y = CubicWeightDerivatives(v - y);
  return {
      (values * weights_y).sum(),
      Eigen::Vector2d((slopes * weights_y).sum(), (values * slopes_y).sum()) / grid_.resolution()};
}

}  // namespace loopscope
