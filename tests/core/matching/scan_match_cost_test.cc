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

Eigen::VectorXd ResidualsAt(const ScanMatchCost& cost, const Eigen::Vector3d& pose) {
  Eigen::VectorXd residuals(cost.NumResiduals());
  cost(pose.data(), residuals.data(), nullptr);
  return residuals;
}

Eigen::MatrixXd NumericJacobian(const ScanMatchCost& cost, const Eigen::Vector3d& pose) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd jacobian(cost.NumResiduals(), 3);
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(i);
    jacobian.col(i) =
        (ResidualsAt(cost, pose + step) - ResidualsAt(cost, pose - step)) / (2.0 * kStep);
  }
  return jacobian;
}

Eigen::Vector3d RandomParameters(const RandomWorld& world, Random* random) {
  return {world.submap_from_scan.x() + random->Uniform(-0.2, 0.2),
          world.submap_from_scan.y() + random->Uniform(-0.2, 0.2),
          world.submap_from_scan.rotation + random->Uniform(-0.2, 0.2)};
}

TEST(ScanMatchCost, HasTheJacobianOfItsResiduals) {
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    const ScanMatchCost cost(world.points_in_scan, world.grid, world.submap_from_scan.translation,
                             world.submap_from_scan.rotation, kOptions);
    const Eigen::Vector3d pose = RandomParameters(world, &random);
    Eigen::VectorXd residuals(cost.NumResiduals());
    Eigen::MatrixXd jacobian(cost.NumResiduals(), 3);
    ASSERT_TRUE(cost(pose.data(), residuals.data(), jacobian.data()));
    EXPECT_EQ(residuals, ResidualsAt(cost, pose));
    EXPECT_NEAR((jacobian - NumericJacobian(cost, pose)).cwiseAbs().maxCoeff(), 0.0, 1e-2)
        << "world " << i;
  }
}

TEST(ScanMatchCost, WeighsWhatEachPointLacksByTheNumberOfPoints) {
  Random random(2);
  const RandomWorld world = MakeRandomWorld(&random);
  const ScanMatchCost cost(world.points_in_scan, world.grid, {0.0, 0.0}, 0.0, kOptions);
  const int num_points = static_cast<int>(world.points_in_scan.size());
  const Eigen::Vector3d pose = RandomParameters(world, &random);
  const Eigen::VectorXd residuals = ResidualsAt(cost, pose);
  const BicubicGrid smooth(world.grid);
  ASSERT_EQ(residuals.size(), num_points + 3);
  for (int k = 0; k < num_points; ++k) {
    const Eigen::Vector2d point = Pose2(pose.x(), pose.y(), pose.z()) * world.points_in_scan[k];
    EXPECT_NEAR(residuals[k],
                3.0 / std::sqrt(num_points) * (1.0 - SmoothValueAt(smooth, point).value), 1e-9);
  }
}

TEST(ScanMatchCost, EndsWithThePriorsOnTranslationAndRotation) {
  const PointCloud points = {{1.0, 0.0}};
  const ProbabilityGrid grid(0.05);
  const ScanMatchCost cost(points, grid, {5.0, 6.0}, 0.5, kOptions);
  const Eigen::VectorXd residuals = ResidualsAt(cost, {5.1, 5.8, 0.8});
  EXPECT_NEAR(residuals[1], 10.0 * 0.1, 1e-12);
  EXPECT_NEAR(residuals[2], 10.0 * -0.2, 1e-12);
  EXPECT_NEAR(residuals[3], 40.0 * 0.3, 1e-12);
}

}  // namespace
}  // namespace loopscope
