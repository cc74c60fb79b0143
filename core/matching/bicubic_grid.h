// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/probability_grid.h"

namespace loopscope {

/// A value of M_smooth and its derivative by the place.
struct SmoothValue {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  ///< [1/m]
};

/// M_smooth of (CS): the probabilities of a grid, interpolated by bicubic (Catmull-Rom) convolution
/// between the grid points; Keys, "Cubic Convolution Interpolation", 1981. Unknown cells count as
/// kMinProbability. Overshoots a little out of [0.1, 0.9].
class BicubicGrid {
 public:
  /// Keeps a reference to `grid`.
  explicit BicubicGrid(const ProbabilityGrid& grid) : grid_(grid) {}

  SmoothValue At(const Eigen::Vector2d& point) const;

 private:
  const ProbabilityGrid& grid_;
};

}  // namespace loopscope
