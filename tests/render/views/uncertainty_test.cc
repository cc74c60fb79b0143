// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/uncertainty.h"

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

UncertainPoint PointOfDeviation(double deviation) {
  return {Eigen::Vector2d::Zero(), deviation * deviation * Eigen::Matrix2d::Identity()};
}

TEST(EllipseFactorTest, MakesTheLargestEllipseAlmostAsLargeAsItMayBe) {
  const std::vector<UncertainPoint> points{PointOfDeviation(1e-4), PointOfDeviation(3e-4)};
  EXPECT_DOUBLE_EQ(EllipseFactor(points, 0.2), 500.0);  // radius 0.15
  EXPECT_DOUBLE_EQ(EllipseFactor(points, 0.1), 200.0);
}

TEST(EllipseFactorTest, IsOneWhereNothingIsUncertain) {
  EXPECT_EQ(EllipseFactor({}, 1.0), 1.0);
  EXPECT_EQ(EllipseFactor({PointOfDeviation(0.0)}, 1.0), 1.0);
}

TEST(UncertaintyOfSubmapsTest, IsThatOfSubmapsEvenlySpreadUpToTheLast) {
  ScanLog log = SimulateSmallLoop().log;
  log.scans.resize(60);
  const Recording recording = MapLog(log, SmallLoopOptions());
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  const auto points = UncertaintyOfSubmaps(recording, state, 2);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[1].mean, state.global_from_submap.back().translation);
  EXPECT_GT(points[0].LargestDeviation(), 0.0);
  EXPECT_GT(points[1].LargestDeviation(), points[0].LargestDeviation());
}

}  // namespace
}  // namespace loopscope
