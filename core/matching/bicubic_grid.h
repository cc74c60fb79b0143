// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// Values of M_smooth and their derivatives by the place.
struct SmoothValues {
  std::vector<double> values;
  std::vector<double> slopes_x;       ///< [1/m]
  std::vector<double> slopes_y;       ///< [1/m]
  std::vector<double> curvatures_xx;  ///< [1/m^2]
  std::vector<double> curvatures_xy;
  std::vector<double> curvatures_yy;
};

/// M_smooth of (CS): the probabilities of a grid, interpolated by bicubic (Catmull-Rom) convolution
/// between the grid points; Keys, "Cubic Convolution Interpolation", 1981. Unknown cells count as
/// kMinProbability. Overshoots a little out of [0.1, 0.9].
class BicubicGrid {
 public:
  /// Keeps a reference to `grid`.
  explicit BicubicGrid(const ProbabilityGrid& grid) : grid_(grid) {}

  /// At each of `points` [m], in the frame of the grid. The same numbers on any processor.
  SmoothValues At(const PointCloud& points) const;

 private:
  const ProbabilityGrid& grid_;
};

}  // namespace loopscope
