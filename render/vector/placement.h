// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

namespace loopscope {

/// From the coordinates of a panel, or of the sheet, to those of a canvas: x to the right, y down.
struct Placement {
  Eigen::Matrix<double, 2, 3> turn = Eigen::Matrix<double, 2, 3>::Zero();
  Eigen::Vector2d shift = Eigen::Vector2d::Zero();
  Eigen::Vector2d corner = Eigen::Vector2d::Zero();  ///< of the panel: the upper left one
  double unit = 1.0;  ///< of the canvas for a pixel of the scene: scales widths and texts

  Eigen::Vector2d At(const double* point) const {
    return turn * Eigen::Map<const Eigen::Vector3d>(point) + shift;
  }
};

}  // namespace loopscope
