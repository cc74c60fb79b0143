// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/spa_cost.h"

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

Pose2 RandomPose(Random* random) {
  return {random->Uniform(-3.0, 3.0), random->Uniform(-3.0, 3.0), random->Uniform(-3.0, 3.0)};
}

/// `pose` with its number `k` (x, y, theta) changed by `step`, and the angle as it is.
Pose2 Changed(Pose2 pose, int k, double step) {
  if (k < 2) {
    pose.translation[k] += step;
  } else {
    pose.rotation += step;
  }
  return pose;
}

/// How `error` changes with the numbers of a pose, given as a function of it.
template <typename Error>
Eigen::Matrix3d NumericDerivatives(const Error& error, const Pose2& pose) {
  constexpr double kStep = 1e-6;
  Eigen::Matrix3d derivatives;
  for (int k = 0; k < 3; ++k) {
    derivatives.col(k) =
        (error(Changed(pose, k, kStep)) - error(Changed(pose, k, -kStep))) / (2.0 * kStep);
  }
  return derivatives;
}

TEST(SpaQuadratic, IsMadeOfTheDerivativesOfTheError) {
  const SpaInformation information{7.0, 3.0};
  const Eigen::DiagonalMatrix<double, 3> w(7.0, 7.0, 3.0);
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const Pose2 i = RandomPose(&random);
    const Pose2 j = RandomPose(&random);
    // The measured turn is near the real one: away from where the error jumps by a turn.
    const Pose2 i_from_j(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0),
                         j.rotation - i.rotation + random.Uniform(-2.0, 2.0));
    const Eigen::Vector3d error = SpaError(i_from_j, i, j);
    const Eigen::Matrix3d by_i =
        NumericDerivatives([&](const Pose2& at) { return SpaError(i_from_j, at, j); }, i);
    const Eigen::Matrix3d by_j =
        NumericDerivatives([&](const Pose2& at) { return SpaError(i_from_j, i, at); }, j);
    const SpaQuadratic quadratic(GlobalSpaError(i_from_j, i, i.RotationMatrix(), j), i, j,
                                 information);
    EXPECT_LT((quadratic.ii - by_i.transpose() * w * by_i).norm(), 1e-5);
    EXPECT_LT((quadratic.ji - by_j.transpose() * w * by_i).norm(), 1e-5);
    EXPECT_LT((quadratic.jj - by_j.transpose() * w * by_j).norm(), 1e-5);
    EXPECT_LT((quadratic.by_i - by_i.transpose() * w * error).norm(), 1e-5);
    EXPECT_LT((quadratic.by_j - by_j.transpose() * w * error).norm(), 1e-5);
  }
}

TEST(SpaInformation, WeighsTheErrorAlikeInBothFrames) {
  const SpaInformation information{7.0, 3.0};
  Random random(4);
  for (int round = 0; round < 20; ++round) {
    const Pose2 i = RandomPose(&random);
    const Pose2 j = RandomPose(&random);
    const Pose2 i_from_j = RandomPose(&random);
    const Eigen::Vector3d error = SpaError(i_from_j, i, j);
    const double square = 7.0 * error.head<2>().squaredNorm() + 3.0 * error.z() * error.z();
    EXPECT_NEAR(information.SquareOf(error), square, 1e-9);
    EXPECT_NEAR(information.SquareOf(GlobalSpaError(i_from_j, i, i.RotationMatrix(), j)), square,
                1e-9);
  }
}

TEST(SpaError, IsZeroWhereThePosesStandAsMeasured) {
  Random random(2);
  for (int round = 0; round < 20; ++round) {
    const Pose2 global_from_i = RandomPose(&random);
    const Pose2 i_from_j = RandomPose(&random);
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
