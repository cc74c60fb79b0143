// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include "render/palette.h"

namespace loopscope {

/// A place in the map and how sure it is.
struct UncertainPoint {
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();        ///< [m]
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  ///< [m^2]

  /// Of the most uncertain direction [m].
  double LargestDeviation() const;
};

/// Points on the ellipse of `factor` standard deviations around the mean, counter-clockwise.
std::vector<Eigen::Vector2d> EllipseOf(const UncertainPoint& point, double factor);

/// The ellipses of `factor` standard deviations.
vtkSmartPointer<vtkActor> EllipsesLayer(const std::vector<UncertainPoint>& points, double factor,
                                        const Color& color, double line_width);

}  // namespace loopscope
