// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/lidar.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

FloorPlan Square() {
  FloorPlan plan;
  plan.AddPolygon({{-2.0, -2.0}, {2.0, -2.0}, {2.0, 2.0}, {-2.0, 2.0}});
  return plan;
}

LidarOptions Perfect() {
  LidarOptions options;
  options.range_noise = 0.0;
  options.range_step = 1e-4;
  options.dropout_probability = 0.0;
  return options;
}

TEST(SimulateScan, MeasuresFromTheScannerAlongItsBeams) {
  LidarOptions options = Perfect();
  options.beams = {3, DegreesToRadians(-90.0), DegreesToRadians(90.0)};
  Random random(1);
  const RayCaster ray_caster(Square());
  const auto ranges = SimulateScan(ray_caster, Pose2(1.0, 0.5, 0.0), options, &random);
  EXPECT_EQ(ranges, (std::vector<float>{2.5f, 1.0f, 1.5f}));
  // Turned to the left by a quarter.
  const auto turned =
      SimulateScan(ray_caster, Pose2(1.0, 0.5, DegreesToRadians(90.0)), options, &random);
  EXPECT_EQ(turned, (std::vector<float>{1.0f, 1.5f, 3.0f}));
}

TEST(SimulateScan, HasNoReturnBeyondItsRange) {
  LidarOptions options = Perfect();
  options.beams = {2, 0.0, DegreesToRadians(45.0)};
  options.max_range = 2.1;
  Random random(1);
  const auto ranges = SimulateScan(RayCaster(Square()), Pose2(), options, &random);
  EXPECT_EQ(ranges, (std::vector<float>{2.0f, INFINITY}));
}

TEST(SimulateScan, HasTheNoiseAndTheDropoutsThatWereAskedFor) {
  LidarOptions options = Perfect();
  options.beams = {20000, 0.0, 0.0};
  options.range_noise = 0.05;
  options.dropout_probability = 0.1;
  Random random(2);
  const auto ranges = SimulateScan(RayCaster(Square()), Pose2(), options, &random);
  int num_returns = 0;
  double sum = 0.0, sum_of_squares = 0.0;
  for (const float range : ranges) {
    if (std::isinf(range)) continue;
    ++num_returns;
    sum += range - 2.0;
    sum_of_squares += (range - 2.0) * (range - 2.0);
  }
  EXPECT_NEAR(num_returns, 18000, 200);
  EXPECT_NEAR(sum / num_returns, 0.0, 0.002);
  EXPECT_NEAR(std::sqrt(sum_of_squares / num_returns), 0.05, 0.002);
}

TEST(SimulateScan, ReadsInSteps) {
  LidarOptions options = Perfect();
  options.range_noise = 0.5;
  options.range_step = 0.25;
  Random random(2);
  for (const float range : SimulateScan(RayCaster(Square()), Pose2(), options, &random)) {
    EXPECT_EQ(range, std::round(range / 0.25f) * 0.25f);
    EXPECT_GT(range, 0.0f);
  }
}

}  // namespace
}  // namespace loopscope
