// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/covariance.h"

#include <cmath>

#include <Eigen/Eigenvalues>

#include "render/layers/shapes.h"

namespace loopscope {
namespace {

/// Takes the unit circle to the ellipse of one standard deviation.
Eigen::Matrix2d RootOf(const Eigen::Matrix2d& covariance) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance);
  const Eigen::Vector2d deviations = solver.eigenvalues().cwiseMax(0.0).cwiseSqrt();
  return solver.eigenvectors() * deviations.asDiagonal() * solver.eigenvectors().transpose();
}

}  // namespace

double UncertainPoint::LargestDeviation() const {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(covariance, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues().maxCoeff()));
}

std::vector<Eigen::Vector2d> EllipseOf(const UncertainPoint& point, double factor) {
  constexpr int kCorners = 48;
  const Eigen::Matrix2d map_from_circle = factor * RootOf(point.covariance);
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    corners.push_back(point.mean +
                      map_from_circle * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

vtkSmartPointer<vtkActor> EllipsesLayer(const std::vector<UncertainPoint>& points, double factor,
                                        const Color& color, double line_width) {
  Shapes shapes;
  for (const UncertainPoint& point : points) shapes.AddOutline(EllipseOf(point, factor), color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
