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

TEST(SpaError, HasTheDerivativesThatItSays) {
  constexpr double kStep = 1e-6;
  Random random(1);
  for (int round = 0; round < 50; ++round) {
    const Pose2 i = RandomPose(&random);
    const Pose2 j = RandomPose(&random);
    // The measured turn is near the real one: away from where the error jumps by a turn.
    const Pose2 i_from_j(random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0),
                         j.rotation - i.rotation + random.Uniform(-2.0, 2.0));
    const SpaDerivatives derivatives = DerivativesOfSpaError(i, i.RotationMatrix().transpose(), j);
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d by_i = (SpaError(i_from_j, Changed(i, k, kStep), j) -
                                    SpaError(i_from_j, Changed(i, k, -kStep), j)) /
                                   (2.0 * kStep);
      const Eigen::Vector3d by_j = (SpaError(i_from_j, i, Changed(j, k, kStep)) -
                                    SpaError(i_from_j, i, Changed(j, k, -kStep))) /
                                   (2.0 * kStep);
      EXPECT_LT((derivatives.by_i.col(k) - by_i).norm(), 1e-7) << k;
      EXPECT_LT((derivatives.by_j.col(k) - by_j).norm(), 1e-7) << k;
    }
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
