// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/matching/bicubic_grid.h"

namespace loopscope {

/// A value of M_smooth and its derivatives by the place.
struct SmoothValue {
  double value = 0.0;
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();  ///< [1/m]
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();   ///< [1/m^2]
};

inline SmoothValue SmoothValueAt(const BicubicGrid& smooth, const Eigen::Vector2d& point) {
  const SmoothValues found = smooth.At({point});
  Eigen::Matrix2d hessian;
  hessian << found.curvatures_xx[0], found.curvatures_xy[0], found.curvatures_xy[0],
      found.curvatures_yy[0];
  return {found.values[0], {found.slopes_x[0], found.slopes_y[0]}, hessian};
}

}  // namespace loopscope
