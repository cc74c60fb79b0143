// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/bicubic_grid.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/random_world.h"
#include "tests/support/smooth_value.h"

namespace loopscope {
namespace {

constexpr double kCellValueStep = (kMaxProbability - kMinProbability) / (kMaxCellValue - 1);

Eigen::Vector2d RandomPointIn(const ProbabilityGrid& grid, Random* random) {
  // Two cells beyond the box as well.
  const CellBox& box = grid.box();
  return grid.resolution() * Eigen::Vector2d{box.min.x + random->Uniform(-2.0, box.width + 2.0),
                                             box.min.y + random->Uniform(-2.0, box.height + 2.0)};
}

Eigen::Vector2d NumericGradient(const BicubicGrid& smooth, const Eigen::Vector2d& point) {
  constexpr double kStep = 1e-6;
  Eigen::Vector2d gradient;
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
    gradient[axis] =
        (SmoothValueAt(smooth, point + step).value - SmoothValueAt(smooth, point - step).value) /
        (2.0 * kStep);
  }
  return gradient;
}

/// A grid of 12 x 12 cells at resolution 0.5 whose probability is `value(x, y)` in cells.
template <typename Function>
ProbabilityGrid GridOf(const Function& value) {
  ProbabilityGrid grid(0.5);
  grid.GrowToInclude({{0, 0}, 12, 12});
  for (int y = 0; y < 12; ++y) {
    for (int x = 0; x < 12; ++x) grid.Update({{x, y}}, OddsUpdate(value(x, y)));
  }
  return grid;
}

TEST(BicubicGrid, MeetsTheProbabilitiesAtTheGridPoints) {
  Random random(1);
  const ProbabilityGrid grid = RandomGrid(&random);
  const BicubicGrid smooth(grid);
  const CellBox& box = grid.box();
  for (int y = box.min.y - 2; y < box.min.y + box.height + 2; ++y) {
    for (int x = box.min.x - 2; x < box.min.x + box.width + 2; ++x) {
      EXPECT_NEAR(SmoothValueAt(smooth, CenterOf({x, y}, grid.resolution())).value,
                  grid.probability({x, y}), 1e-9);
    }
  }
}

TEST(BicubicGrid, HasTheGradientOfItsValue) {
  Random random(2);
  const ProbabilityGrid grid = RandomGrid(&random);
  const BicubicGrid smooth(grid);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d point = RandomPointIn(grid, &random);
    const Eigen::Vector2d expected = NumericGradient(smooth, point);
    EXPECT_NEAR((SmoothValueAt(smooth, point).gradient - expected).norm(), 0.0, 1e-2)
        << "at " << point.transpose() << " expected " << expected.transpose();
  }
}

TEST(BicubicGrid, HasTheCurvatureOfItsGradient) {
  Random random(7);
  const ProbabilityGrid grid = RandomGrid(&random);
  const BicubicGrid smooth(grid);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d point = RandomPointIn(grid, &random);
    const Eigen::Matrix2d hessian = SmoothValueAt(smooth, point).hessian;
    constexpr double kStep = 1e-7;
    for (int axis = 0; axis < 2; ++axis) {
      const Eigen::Vector2d step = kStep * Eigen::Vector2d::Unit(axis);
      const Eigen::Vector2d expected = (SmoothValueAt(smooth, point + step).gradient -
                                        SmoothValueAt(smooth, point - step).gradient) /
                                       (2.0 * kStep);
      EXPECT_NEAR((hessian.col(axis) - expected).norm(), 0.0, 1e-2 + 1e-5 * expected.norm())
          << "at " << point.transpose() << " expected " << expected.transpose();
    }
  }
}

TEST(BicubicGrid, IsTheSameAtManyPointsAsAtEach) {
  Random random(6);
  for (int i = 0; i < 20; ++i) {
    const ProbabilityGrid grid = RandomGrid(&random);
    const BicubicGrid smooth(grid);
    PointCloud points;
    for (int k = 0; k < 101; ++k) points.push_back(RandomPointIn(grid, &random));
    const SmoothValues many = smooth.At(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
      const SmoothValue one = SmoothValueAt(smooth, points[k]);
      EXPECT_EQ(many.values[k], one.value);
      EXPECT_EQ(many.slopes_x[k], one.gradient.x());
      EXPECT_EQ(many.slopes_y[k], one.gradient.y());
      EXPECT_EQ(many.curvatures_xx[k], one.hessian(0, 0));
      EXPECT_EQ(many.curvatures_xy[k], one.hessian(0, 1));
      EXPECT_EQ(many.curvatures_yy[k], one.hessian(1, 1));
    }
  }
}

TEST(BicubicGrid, HasNoStepOrKinkBetweenItsPatches) {
  Random random(3);
  const ProbabilityGrid grid = RandomGrid(&random);
  const BicubicGrid smooth(grid);
  for (int i = 0; i < 500; ++i) {
    Eigen::Vector2d point = RandomPointIn(grid, &random);
    const int axis = i % 2;
    point[axis] = grid.resolution() * std::round(point[axis] / grid.resolution());
    const Eigen::Vector2d aside = 1e-9 * Eigen::Vector2d::Unit(axis);
    const SmoothValue before = SmoothValueAt(smooth, point - aside);
    const SmoothValue after = SmoothValueAt(smooth, point + aside);
    EXPECT_NEAR(before.value, after.value, 1e-6);
    EXPECT_NEAR((before.gradient - after.gradient).norm(), 0.0, 1e-4);
  }
}

TEST(BicubicGrid, ReproducesAParabola) {
  // Cubic convolution of third order (Keys 1981) is exact up to the second degree.
  const auto parabola = [](double x, double y) {
    return 0.3 + 0.03 * x - 0.02 * y + 0.002 * x * x + 0.001 * x * y + 0.001 * y * y;
  };
  const ProbabilityGrid grid = GridOf(parabola);
  const BicubicGrid smooth(grid);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const double x = random.Uniform(1.0, 10.0);
    const double y = random.Uniform(1.0, 10.0);
    const SmoothValue at = SmoothValueAt(smooth, 0.5 * Eigen::Vector2d(x, y));
    EXPECT_NEAR(at.value, parabola(x, y), 2.0 * kCellValueStep);
    EXPECT_NEAR(at.gradient.x(), (0.03 + 0.004 * x + 0.001 * y) / 0.5, 1e-3);
    EXPECT_NEAR(at.gradient.y(), (-0.02 + 0.001 * x + 0.002 * y) / 0.5, 1e-3);
  }
}

TEST(BicubicGrid, IsFlatAtTheLeastProbabilityFarFromTheMap) {
  Random random(5);
  const ProbabilityGrid grid = RandomGrid(&random);
  const SmoothValue far = SmoothValueAt(BicubicGrid(grid), {100.0, -100.0});
  EXPECT_NEAR(far.value, kMinProbability, 1e-12);
  EXPECT_NEAR(far.gradient.norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace loopscope
