// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/scan_match_cost.h"

#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/random_world.h"
#include "tests/support/smooth_value.h"

namespace loopscope {
namespace {

const CeresScanMatcherOptions kOptions{3.0, 10.0, 40.0, 20};

/// The derivatives at `pose` by differences.
QuadraticModel NumericModel(const ScanMatchCost& cost, const Eigen::Vector3d& pose) {
  constexpr double kStep = 1e-6;
  QuadraticModel numeric;
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    const QuadraticModel after = cost.At(pose + step);
    const QuadraticModel before = cost.At(pose - step);
    numeric.gradient[i] = (after.cost - before.cost) / (2.0 * kStep);
    numeric.hessian.col(i) = (after.gradient - before.gradient) / (2.0 * kStep);
  }
  return numeric;
}

Eigen::Vector3d RandomParameters(const RandomWorld& world, Random* random) {
  return {world.submap_from_scan.x() + random->Uniform(-0.2, 0.2),
          world.submap_from_scan.y() + random->Uniform(-0.2, 0.2),
          world.submap_from_scan.rotation + random->Uniform(-0.2, 0.2)};
}

TEST(ScanMatchCost, HasTheDerivativesOfItself) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    const ScanMatchCost cost(world.points_in_scan, world.grid, world.submap_from_scan.translation,
                             world.submap_from_scan.rotation, kOptions);
    const Eigen::Vector3d pose = RandomParameters(world, &random);
    const QuadraticModel model = cost.At(pose);
    const QuadraticModel numeric = NumericModel(cost, pose);
    EXPECT_NEAR((model.gradient - numeric.gradient).norm(), 0.0, 1e-5 * numeric.gradient.norm())
        << "world " << i;
    EXPECT_NEAR((model.hessian - numeric.hessian).norm(), 0.0, 1e-4 * numeric.hessian.norm())
        << "world " << i;
    EXPECT_EQ(model.hessian, model.hessian.transpose());
  }
}

TEST(ScanMatchCost, IsThatOfTheProbabilitiesAtThePointsAndOfThePriors) {
  Random random(2);
  const RandomWorld world = MakeRandomWorld(&random);
  const ScanMatchCost cost(world.points_in_scan, world.grid, {5.0, 6.0}, 0.5, kOptions);
  const Eigen::Vector3d pose = RandomParameters(world, &random);
  const BicubicGrid smooth(world.grid);
  double sum = 0.0;
  for (const Eigen::Vector2d& point : world.points_in_scan) {
    const Eigen::Vector2d place = Pose2(pose.x(), pose.y(), pose.z()) * point;
    sum += std::pow(1.0 - SmoothValueAt(smooth, place).value, 2);
  }
  const double of_points = 9.0 / static_cast<double>(world.points_in_scan.size()) * sum;
  const double of_priors = 100.0 * std::pow(pose.x() - 5.0, 2) +
                           100.0 * std::pow(pose.y() - 6.0, 2) +
                           1600.0 * std::pow(pose.z() - 0.5, 2);
  EXPECT_NEAR(cost.At(pose).cost, 0.5 * (of_points + of_priors), 1e-9 * of_priors);
}

TEST(ScanMatchCost, IsThatOfThePriorsBesidesWhatIsMissingOffTheMap) {
  const PointCloud points = {{1.0, 0.0}};
  const ProbabilityGrid grid(0.05);
  const ScanMatchCost cost(points, grid, {5.0, 6.0}, 0.5, kOptions);
  const double missing = 9.0 * 0.9 * 0.9;
  EXPECT_NEAR(cost.At({5.1, 5.8, 0.8}).cost, 0.5 * (missing + 1.0 + 4.0 + 144.0), 1e-9);
}

}  // namespace
}  // namespace loopscope
