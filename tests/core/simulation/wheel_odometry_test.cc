// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/wheel_odometry.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

const WheelOdometryOptions kPerfect{1.0, 1.0, 0.0, 0.0, 0.0, 0.0};

TEST(WheelOdometry, FollowsTheRobotExactlyWithoutFaults) {
  Random random(1);
  WheelOdometry odometry(kPerfect);
  Pose2 odom_from_base;
  for (int i = 0; i < 100; ++i) {
    const Pose2 step(0.1, 0.001 * i, 0.02);
    odometry.Move(step, &random);
    odom_from_base = odom_from_base * step;
  }
  EXPECT_LT((odometry.odom_from_base().translation - odom_from_base.translation).norm(), 1e-9);
  EXPECT_NEAR(odometry.odom_from_base().rotation, odom_from_base.rotation, 1e-9);
}

TEST(WheelOdometry, StandsStillWithTheRobot) {
  Random random(1);
  WheelOdometry odometry{WheelOdometryOptions()};
  odometry.Move(Pose2(), &random);
  EXPECT_EQ(odometry.odom_from_base(), Pose2());
}

TEST(WheelOdometry, BiasesAddUp) {
  Random random(1);
  WheelOdometryOptions options = kPerfect;
  options.distance_scale = 1.1;
  WheelOdometry stretched(options);
  for (int i = 0; i < 100; ++i) stretched.Move(Pose2(0.1, 0.0, 0.0), &random);
  EXPECT_NEAR(stretched.odom_from_base().x(), 11.0, 1e-9);

  options = kPerfect;
  options.turn_scale = 1.05;
  options.turn_per_meter = 0.01;
  WheelOdometry turned(options);
  for (int i = 0; i < 100; ++i) turned.Move(Pose2(0.1, 0.0, 0.01), &random);
  EXPECT_NEAR(turned.odom_from_base().rotation, 1.05 + 0.1, 1e-9);
}

// Standard deviation of the heading after driving 4 m in `num_steps` steps, turning 1 rad.
double SpreadOfHeading(const WheelOdometryOptions& options, int num_steps) {
  Random random(1);
  constexpr int kNumDrives = 2000;
  double sum_of_squares = 0.0;
  for (int drive = 0; drive < kNumDrives; ++drive) {
    WheelOdometry odometry(options);
    for (int i = 0; i < num_steps; ++i) {
      odometry.Move(Pose2(4.0 / num_steps, 0.0, 1.0 / num_steps), &random);
    }
    sum_of_squares += std::pow(odometry.odom_from_base().rotation - 1.0, 2);
  }
  return std::sqrt(sum_of_squares / kNumDrives);
}

TEST(WheelOdometry, NoiseGrowsWithTheRootOfTheWayHoweverItIsDivided) {
  WheelOdometryOptions options = kPerfect;
  options.turn_noise = 0.03;
  EXPECT_NEAR(SpreadOfHeading(options, 4), 0.06, 0.004);
  EXPECT_NEAR(SpreadOfHeading(options, 40), 0.06, 0.004);
  options = kPerfect;
  options.turn_noise_of_turn = 0.05;
  EXPECT_NEAR(SpreadOfHeading(options, 4), 0.05, 0.004);
  EXPECT_NEAR(SpreadOfHeading(options, 40), 0.05, 0.004);
}

}  // namespace
}  // namespace loopscope
