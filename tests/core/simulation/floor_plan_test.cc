// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/floor_plan.h"

#include <gtest/gtest.h>

#include "core/simulation/ray_caster.h"

namespace loopscope {
namespace {

constexpr double kUp = 1.5707963267948966;  // [rad]

TEST(FloorPlan, WallIsSeenAtHalfItsThickness) {
  FloorPlan plan;
  plan.AddRoom({0.0, 0.0}, {4.0, 4.0});
  plan.AddWall({0.0, 2.0}, {4.0, 2.0}, {}, 0.2);
  const RayCaster ray_caster(plan);
  EXPECT_NEAR(*ray_caster.Distance({1.0, 1.0}, kUp, 10.0), 0.9, 1e-9);
  EXPECT_NEAR(*ray_caster.Distance({1.0, 3.0}, -kUp, 10.0), 0.9, 1e-9);
}

TEST(FloorPlan, OneSeesThroughADoorAndMeetsItsJambs) {
  FloorPlan plan;
  plan.AddRoom({0.0, 0.0}, {10.0, 10.0});
  plan.AddWall({0.0, 5.0}, {10.0, 5.0}, {{3.0, 1.0}, {7.0, 2.0}});
  const RayCaster ray_caster(plan);
  EXPECT_NEAR(*ray_caster.Distance({2.4, 1.0}, kUp, 20.0), 3.94, 1e-9);
  EXPECT_NEAR(*ray_caster.Distance({2.6, 1.0}, kUp, 20.0), 8.94, 1e-9);
  EXPECT_NEAR(*ray_caster.Distance({7.9, 1.0}, kUp, 20.0), 8.94, 1e-9);
  EXPECT_NEAR(*ray_caster.Distance({8.1, 1.0}, kUp, 20.0), 3.94, 1e-9);
  EXPECT_NEAR(*ray_caster.Distance({7.0, 5.0}, 0.0, 20.0), 1.0, 1e-9);
}

TEST(FloorPlan, RoomHasNoGapAtItsCorners) {
  FloorPlan plan;
  plan.AddRoom({-1.0, -2.0}, {3.0, 2.0});
  const RayCaster ray_caster(plan);
  for (int i = 0; i < 3600; ++i) {
    EXPECT_TRUE(ray_caster.Distance({0.0, 0.0}, DegreesToRadians(0.1 * i), 10.0)) << i;
  }
}

TEST(FloorPlan, BoxTurnsAroundItsMiddle) {
  FloorPlan plan;
  plan.AddBox(Pose2(1.0, 1.0, kUp), {4.0, 2.0});
  ASSERT_EQ(plan.segments().size(), 4u);
  Eigen::Array2d low(100.0, 100.0), high(-100.0, -100.0);
  for (const Segment& segment : plan.segments()) {
    low = low.min(segment.from.array());
    high = high.max(segment.from.array());
  }
  EXPECT_LT((low - Eigen::Array2d(0.0, -1.0)).abs().maxCoeff(), 1e-9);
  EXPECT_LT((high - Eigen::Array2d(2.0, 3.0)).abs().maxCoeff(), 1e-9);
}

TEST(FloorPlan, PillarHasItsRadius) {
  FloorPlan plan;
  plan.AddPillar({2.0, 3.0}, 0.5);
  for (const Segment& segment : plan.segments()) {
    EXPECT_NEAR((segment.from - Eigen::Vector2d(2.0, 3.0)).norm(), 0.5, 1e-12);
  }
  EXPECT_NEAR(*RayCaster(plan).Distance({2.0, 3.0}, 0.0, 1.0), 0.5, 1e-9);
}

}  // namespace
}  // namespace loopscope
