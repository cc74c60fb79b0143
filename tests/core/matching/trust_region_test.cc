// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/trust_region.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

const Eigen::Vector3d kLowest(1.0, -2.0, 0.5);

QuadraticModel Bowl(const Eigen::Vector3d& point) {
  Eigen::Matrix3d hessian;
  hessian << 4.0, 1.0, 0.0, 1.0, 3.0, 0.5, 0.0, 0.5, 2.0;
  const Eigen::Vector3d from_lowest = point - kLowest;
  return {1.0 + 0.5 * from_lowest.dot(hessian * from_lowest), hessian * from_lowest, hessian};
}

/// Lowest at x = 1 and at x = -1, with a saddle between them at 0.
QuadraticModel TwoValleys(const Eigen::Vector3d& point) {
  const double x = point.x();
  QuadraticModel model;
  model.cost = std::pow(x * x - 1.0, 2) + point.tail<2>().squaredNorm();
  model.gradient = {4.0 * x * (x * x - 1.0), 2.0 * point.y(), 2.0 * point.z()};
  model.hessian.diagonal() << 12.0 * x * x - 4.0, 2.0, 2.0;
  return model;
}

/// Falls ever less steeply: whole Newton steps from beyond 1 lead away.
QuadraticModel SoftWell(const Eigen::Vector3d& point) {
  QuadraticModel model;
  for (int i = 0; i < 3; ++i) {
    const double root = std::sqrt(1.0 + point[i] * point[i]);
    model.cost += root - 1.0;
    model.gradient[i] = point[i] / root;
    model.hessian(i, i) = 1.0 / (root * root * root);
  }
  return model;
}

TEST(MinimizeInTrustRegion, NeedsOneStepWhereTheModelIsTrue) {
  const TrustRegionMinimum minimum =
      MinimizeInTrustRegion(Bowl, {0.0, 0.0, 0.0}, {Eigen::Vector3d::Ones(), 10.0, 20});
  EXPECT_EQ(minimum.num_iterations, 1);
  EXPECT_NEAR((minimum.point - kLowest).norm(), 0.0, 1e-12);
  EXPECT_EQ(minimum.initial_cost, Bowl({0.0, 0.0, 0.0}).cost);
  EXPECT_NEAR(minimum.final_cost, 1.0, 1e-12);
}

TEST(MinimizeInTrustRegion, MakesNoFirstStepBeyondItsRadiusInScaledParameters) {
  const TrustRegionMinimum one_step =
      MinimizeInTrustRegion(Bowl, {0.0, 0.0, 0.0}, {{1.0, 1.0, 4.0}, 0.1, 1});
  EXPECT_NEAR(one_step.point.cwiseProduct(Eigen::Vector3d(1.0, 1.0, 4.0)).norm(), 0.1, 1e-12);
}

TEST(MinimizeInTrustRegion, GetsFarByStepsThatGrow) {
  const TrustRegionMinimum minimum =
      MinimizeInTrustRegion(Bowl, {100.0, 0.0, 0.0}, {Eigen::Vector3d::Ones(), 0.1, 50});
  EXPECT_NEAR((minimum.point - kLowest).norm(), 0.0, 1e-2);
  EXPECT_LT(minimum.num_iterations, 15);
}

TEST(MinimizeInTrustRegion, LeavesASaddleDownhill) {
  const TrustRegionMinimum minimum =
      MinimizeInTrustRegion(TwoValleys, {0.05, 0.3, -0.2}, {Eigen::Vector3d::Ones(), 0.5, 50});
  EXPECT_NEAR((minimum.point - Eigen::Vector3d::UnitX()).norm(), 0.0, 1e-2);
}

TEST(MinimizeInTrustRegion, StepsFromASaddleAsFarAsItsCurvatureSays) {
  const Eigen::Vector3d start(0.05, 0.0, 0.0);
  const QuadraticModel model = TwoValleys(start);
  const TrustRegionMinimum one_step =
      MinimizeInTrustRegion(TwoValleys, start, {Eigen::Vector3d::Ones(), 0.5, 1});
  const double step = model.gradient.x() / model.hessian(0, 0);
  ASSERT_LT(model.hessian(0, 0), 0.0);
  EXPECT_NEAR((one_step.point - start - Eigen::Vector3d(step, 0.0, 0.0)).norm(), 0.0, 1e-12);
}

TEST(MinimizeInTrustRegion, NeverGoesUp) {
  for (int num_iterations = 0; num_iterations < 20; ++num_iterations) {
    const TrustRegionMinimum minimum = MinimizeInTrustRegion(
        SoftWell, {3.0, -2.0, 5.0}, {Eigen::Vector3d::Ones(), 100.0, num_iterations});
    EXPECT_EQ(minimum.num_iterations, num_iterations) << "still on its way";
    EXPECT_LE(minimum.final_cost, minimum.initial_cost);
    EXPECT_EQ(minimum.final_cost, SoftWell(minimum.point).cost);
    if (minimum.final_cost < 1e-6) break;
  }
}

TEST(MinimizeInTrustRegion, EndsWhereWholeStepsWouldLeadAway) {
  const TrustRegionMinimum minimum =
      MinimizeInTrustRegion(SoftWell, {3.0, -2.0, 5.0}, {Eigen::Vector3d::Ones(), 100.0, 50});
  EXPECT_NEAR(minimum.point.norm(), 0.0, 1e-2);
}

TEST(MinimizeInTrustRegion, StaysWhereAllIsFlat) {
  const auto flat = [](const Eigen::Vector3d&) { return QuadraticModel(); };
  const TrustRegionMinimum minimum = MinimizeInTrustRegion(flat, {1.0, 2.0, 3.0}, {});
  EXPECT_EQ(minimum.point, Eigen::Vector3d(1.0, 2.0, 3.0));
  EXPECT_EQ(minimum.num_iterations, 0);
}

}  // namespace
}  // namespace loopscope
