// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/spa_cost.h"

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

using Parameters = Eigen::Matrix<double, 6, 1>;  ///< x, y, theta of i, then of j
using Jacobian = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Parameters RandomParameters(Random* random) {
  Parameters parameters;
  for (int i = 0; i < 6; ++i) parameters[i] = random->Uniform(-3.0, 3.0);
  return parameters;
}

Eigen::Vector3d Residuals(const ceres::CostFunction& cost, const Parameters& parameters) {
  const double* const blocks[] = {parameters.data(), parameters.data() + 3};
  Eigen::Vector3d residuals;
  EXPECT_TRUE(cost.Evaluate(blocks, residuals.data(), nullptr));
  return residuals;
}

Eigen::Vector3d NumericDerivative(const ceres::CostFunction& cost, const Parameters& parameters,
                                  int parameter) {
  constexpr double kStep = 1e-6;
  Parameters low = parameters;
  Parameters high = parameters;
  low[parameter] -= kStep;
  high[parameter] += kStep;
  return (Residuals(cost, high) - Residuals(cost, low)) / (2.0 * kStep);
}

TEST(SpaCost, HasTheDerivativesThatItSays) {
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const Parameters at = RandomParameters(&random);
    // The measured turn is near the real one: away from where the error jumps by a turn.
    const Pose2 i_from_j(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0),
                         at[5] - at[2] + random.Uniform(-2.0, 2.0));
    const auto cost = MakeSpaCost(i_from_j, 3.0, 7.0);
    const double* const blocks[] = {at.data(), at.data() + 3};
    Eigen::Vector3d residuals;
    Jacobian by_i;
    Jacobian by_j;
    double* jacobians[] = {by_i.data(), by_j.data()};
    ASSERT_TRUE(cost->Evaluate(blocks, residuals.data(), jacobians));
    for (int k = 0; k < 3; ++k) {
      EXPECT_LT((by_i.col(k) - NumericDerivative(*cost, at, k)).norm(), 1e-7) << k;
      EXPECT_LT((by_j.col(k) - NumericDerivative(*cost, at, 3 + k)).norm(), 1e-7) << k;
    }
  }
}

TEST(SpaCost, MayBeAskedForOneDerivativeOnly) {
  const auto cost = MakeSpaCost(Pose2(1.0, 2.0, 3.0), 3.0, 7.0);
  const Parameters at = Parameters::Constant(0.5);
  const double* const blocks[] = {at.data(), at.data() + 3};
  Eigen::Vector3d residuals;
  Jacobian by_j;
  double* jacobians[] = {nullptr, by_j.data()};
  ASSERT_TRUE(cost->Evaluate(blocks, residuals.data(), jacobians));
  EXPECT_LT((by_j.col(0) - NumericDerivative(*cost, at, 3)).norm(), 1e-7);
}

TEST(SpaCost, WeighsTheError) {
  const Pose2 i_from_j(1.0, -2.0, 0.5);
  const Pose2 global_from_i(0.3, 0.4, 1.2);
  const Pose2 global_from_j(-2.0, 1.0, 2.2);
  const Eigen::Vector3d error = SpaError(i_from_j, global_from_i, global_from_j);
  Parameters at;
  at << 0.3, 0.4, 1.2, -2.0, 1.0, 2.2;
  const Eigen::Vector3d weighted = Residuals(*MakeSpaCost(i_from_j, 3.0, 7.0), at);
  EXPECT_LT((weighted - Eigen::Vector3d(3.0 * error.x(), 3.0 * error.y(), 7.0 * error.z())).norm(),
            1e-12);
}

TEST(SpaError, IsZeroWhereThePosesStandAsMeasured) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    const Parameters p = RandomParameters(&random);
    const Pose2 global_from_i(p[0], p[1], p[2]);
    const Pose2 i_from_j(p[3], p[4], p[5]);
    EXPECT_LT(SpaError(i_from_j, global_from_i, global_from_i * i_from_j).norm(), 1e-12);
  }
}

TEST(SpaError, IsMeasuredInTheFrameOfTheFirstPose) {
  const Pose2 global_from_i(5.0, 5.0, M_PI / 2.0);
  const Pose2 global_from_j(5.0, 7.0, M_PI / 2.0);  // 2 m ahead of i
  const Eigen::Vector3d error = SpaError(Pose2(2.5, 0.1, 0.2), global_from_i, global_from_j);
  EXPECT_LT((error - Eigen::Vector3d(0.5, 0.1, 0.2)).norm(), 1e-12);
}

TEST(SpaError, TakesTheShorterWayRound) {
  const Eigen::Vector3d error =
      SpaError(Pose2(0.0, 0.0, 0.0), Pose2(0.0, 0.0, M_PI - 0.1), Pose2(0.0, 0.0, -M_PI + 0.1));
  EXPECT_NEAR(error.z(), -0.2, 1e-12);
}

}  // namespace
}  // namespace loopscope
