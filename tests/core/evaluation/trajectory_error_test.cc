// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/trajectory_error.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

const Trajectory kReference = {{1.0, Pose2(0.0, 0.0, 0.0)},
                               {2.0, Pose2(3.0, 1.0, 0.5)},
                               {3.0, Pose2(4.0, -2.0, 1.0)},
                               {4.0, Pose2(-1.0, 5.0, 3.0)}};

Trajectory Moved(const Pose2& map_from_reference) {
  Trajectory moved = kReference;
  for (TimedPose& pose : moved) pose.map_from_base = map_from_reference * pose.map_from_base;
  return moved;
}

/// Sum of squared distances after an alignment.
double CostOf(const std::vector<PosePair>& pairs, const Pose2& reference_from_map) {
  double cost = 0.0;
  for (const PosePair& pair : pairs) {
    cost +=
        (reference_from_map * pair.map_from_base.translation - pair.reference_from_base.translation)
            .squaredNorm();
  }
  return cost;
}

TEST(TrajectoryError, IsZeroForAnyRigidMotionOfTheReference) {
  for (const Pose2& motion :
       {Pose2(10.0, -3.0, 2.5), Pose2(0.0, 0.0, M_PI), Pose2(5.0, 5.0, -1.0)}) {
    const auto error = EvaluateTrajectory(kReference, Moved(motion));
    EXPECT_NEAR(error->translation.max, 0.0, 1e-12);
    EXPECT_NEAR(error->rotation.max, 0.0, 1e-12);
    EXPECT_NEAR((error->reference_from_map * motion).translation.norm(), 0.0, 1e-12);
  }
}

TEST(TrajectoryError, IsThatOfTheBestAlignment) {
  Trajectory estimate = Moved(Pose2(2.0, 1.0, 0.7));
  estimate[1].map_from_base.translation.x() += 0.3;
  estimate[3].map_from_base.translation.y() -= 0.2;
  const std::vector<PosePair> pairs = PairByTime(kReference, estimate);
  const Pose2 best = AlignToReference(pairs);
  const double cost = CostOf(pairs, best);
  for (const double step : {-1e-3, 1e-3}) {
    EXPECT_GT(CostOf(pairs, Pose2(best.x() + step, best.y(), best.rotation)), cost);
    EXPECT_GT(CostOf(pairs, Pose2(best.x(), best.y() + step, best.rotation)), cost);
    EXPECT_GT(CostOf(pairs, Pose2(best.x(), best.y(), best.rotation + step)), cost);
  }
  const auto error = EvaluateTrajectory(kReference, estimate);
  EXPECT_NEAR(error->translation.rmse, std::sqrt(cost / 4.0), 1e-12);
}

TEST(TrajectoryError, LeavesOutWhatTheEstimateDoesNotCover) {
  const Trajectory estimate = {{1.5, Pose2(1.5, 0.5, 0.25)}, {3.5, Pose2(1.5, 1.5, 2.0)}};
  const std::vector<PosePair> pairs = PairByTime(kReference, estimate);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].time, 2.0);
  EXPECT_NEAR(pairs[0].map_from_base.y(), 0.75, 1e-12);
  EXPECT_FALSE(EvaluateTrajectory(kReference, {{7.0, Pose2()}}));
  EXPECT_FALSE(EvaluateTrajectory(kReference, {}));
}

TEST(TrajectoryError, OfARobotThatStoodStillIsAlignedByHeadings) {
  const Trajectory still = {{1.0, Pose2(1.0, 1.0, 3.0)}, {2.0, Pose2(1.0, 1.0, 3.1)}};
  EXPECT_EQ(EvaluateTrajectory(still, still)->reference_from_map, Pose2());
  const Trajectory shaking = {{1.0, Pose2(2.0, 1.0, -2.9)}, {2.0, Pose2(2.0, 1.000001, -2.8)}};
  const auto error = EvaluateTrajectory(still, shaking);
  EXPECT_NEAR(error->reference_from_map.rotation, 5.9 - 2.0 * M_PI, 1e-9);
  EXPECT_NEAR(error->translation.max, 0.0, 1e-5);
}

}  // namespace
}  // namespace loopscope
