// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/drive.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr double kPeriod = 0.05;  // [s]

// Out, around two corners, and back over the same way.
const std::vector<Eigen::Vector2d> kRoute = {{0.0, 0.0}, {5.0, 0.0}, {5.0, 4.0},
                                             {9.0, 4.0}, {5.0, 4.0}, {5.0, 0.0}};

struct Motion {
  double speed;      // [m/s]
  double turn_rate;  // [rad/s]
};

std::vector<Motion> Motions(const Trajectory& trajectory) {
  std::vector<Motion> motions;
  for (size_t i = 1; i < trajectory.size(); ++i) {
    const Pose2 move = trajectory[i - 1].map_from_base.Inverse() * trajectory[i].map_from_base;
    motions.push_back({move.translation.norm() / kPeriod, move.rotation / kPeriod});
  }
  return motions;
}

TEST(Drive, BeginsOnTheFirstWaypointHeadingForTheSecond) {
  const Trajectory trajectory = Drive({{1.0, 2.0}, {1.0, 7.0}}, DriveOptions(), kPeriod);
  EXPECT_EQ(trajectory.front().time, 0.0);
  EXPECT_EQ(trajectory.front().map_from_base, Pose2(1.0, 2.0, std::atan2(5.0, 0.0)));
}

TEST(Drive, ComesNearEveryWaypointInTurnAndStopsAtTheLast) {
  const Trajectory trajectory = Drive(kRoute, DriveOptions(), kPeriod);
  auto pose = trajectory.begin();
  for (const Eigen::Vector2d& waypoint : kRoute) {
    pose = std::find_if(pose, trajectory.end(), [&](const TimedPose& at) {
      return (at.map_from_base.translation - waypoint).norm() < 0.31;
    });
    ASSERT_NE(pose, trajectory.end()) << waypoint.transpose();
  }
  EXPECT_LT((trajectory.back().map_from_base.translation - kRoute.back()).norm(), 0.1);
  EXPECT_LT(Motions(trajectory).back().speed, 0.3);
}

TEST(Drive, HoldsTheLimitsOfTheRobot) {
  const DriveOptions options;
  const std::vector<Motion> motions = Motions(Drive(kRoute, options, kPeriod));
  double fastest = 0.0, fastest_turn = 0.0;
  for (size_t i = 0; i < motions.size(); ++i) {
    EXPECT_LE(motions[i].speed, options.max_speed + 1e-9);
    EXPECT_LE(std::abs(motions[i].turn_rate), options.max_turn_rate + 1e-9);
    fastest = std::max(fastest, motions[i].speed);
    fastest_turn = std::max(fastest_turn, std::abs(motions[i].turn_rate));
    if (i == 0) continue;
    EXPECT_LE(std::abs(motions[i].speed - motions[i - 1].speed),
              options.acceleration * kPeriod + 1e-3);
    EXPECT_LE(std::abs(motions[i].turn_rate - motions[i - 1].turn_rate),
              options.turn_acceleration * kPeriod + 1e-9);
  }
  EXPECT_GT(fastest, 0.9 * options.max_speed);
  EXPECT_GT(fastest_turn, 0.9 * options.max_turn_rate);
}

TEST(Drive, NeverMovesSideways) {
  const Trajectory trajectory = Drive(kRoute, DriveOptions(), 0.01);
  for (size_t i = 1; i < trajectory.size(); ++i) {
    const Pose2 move = trajectory[i - 1].map_from_base.Inverse() * trajectory[i].map_from_base;
    EXPECT_NEAR(move.y(), move.x() * std::tan(move.rotation / 2.0), 1e-9);
  }
}

TEST(Drive, GivesPosesAtThePeriod) {
  const Trajectory trajectory = Drive(kRoute, DriveOptions(), kPeriod);
  for (size_t i = 0; i < trajectory.size(); ++i) EXPECT_DOUBLE_EQ(trajectory[i].time, i * kPeriod);
}

}  // namespace
}  // namespace loopscope
