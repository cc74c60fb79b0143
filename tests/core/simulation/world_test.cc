// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/world.h"

#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/drive.h"
#include "core/simulation/furniture.h"

namespace loopscope {
namespace {

using ::testing::HasSubstr;

double DistanceTo(const Segment& segment, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = segment.to - segment.from;
  const double share = (point - segment.from).dot(along) / along.squaredNorm();
  return (segment.from + std::clamp(share, 0.0, 1.0) * along - point).norm();
}

class EveryWorld : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Worlds, EveryWorld, ::testing::ValuesIn(WorldNames()),
                         [](const auto& world) { return world.param; });

TEST_P(EveryWorld, RouteKeepsClearOfAllThatStandsThere) {
  constexpr double kRobotRadius = 0.3;  // [m]
  const World world = MakeWorld(GetParam());
  for (const TimedPose& pose : Drive(world.route, DriveOptions(), 0.2)) {
    for (const Segment& segment : world.plan.segments()) {
      ASSERT_GT(DistanceTo(segment, pose.map_from_base.translation), kRobotRadius)
          << "at " << pose.map_from_base.translation.transpose() << ", t = " << pose.time;
    }
  }
}

TEST_P(EveryWorld, ComesBackToWhereItHasBeen) {
  const World world = MakeWorld(GetParam());
  const Trajectory trajectory = Drive(world.route, DriveOptions(), 1.0);
  int num_revisits = 0;
  for (size_t i = 0; i < trajectory.size(); ++i) {
    for (size_t j = 0; j + 60 < i; ++j) {
      num_revisits +=
          (trajectory[i].map_from_base.translation - trajectory[j].map_from_base.translation)
              .norm() < 1.0;
    }
  }
  EXPECT_GT(num_revisits, 5);
}

TEST_P(EveryWorld, IsTheSameEachTime) {
  const World a = MakeWorld(GetParam());
  const World b = MakeWorld(GetParam());
  EXPECT_EQ(a.name, GetParam());
  EXPECT_FALSE(a.description.empty());
  ASSERT_EQ(a.plan.segments().size(), b.plan.segments().size());
  for (size_t i = 0; i < a.plan.segments().size(); ++i) {
    EXPECT_EQ(a.plan.segments()[i].from, b.plan.segments()[i].from);
    EXPECT_EQ(a.plan.segments()[i].to, b.plan.segments()[i].to);
  }
}

TEST(MakeWorld, NamesTheWorldsThereAreIfAskedForAnother) {
  try {
    MakeWorld("ofice");
    FAIL() << "expected an exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("\"ofice\""));
    EXPECT_THAT(error.what(), HasSubstr("office, loop, warehouse"));
  }
}

TEST(Furnish, StaysInsideTheRoom) {
  const Pose2 world_from_room(3.0, -2.0, 0.7);
  const Eigen::Vector2d size(9.0, 5.5);
  for (const RoomUse use : {RoomUse::kOffice, RoomUse::kMeeting, RoomUse::kStorage}) {
    Random random(1);
    FloorPlan plan;
    Furnish(use, world_from_room, size, &random, &plan);
    EXPECT_GT(plan.segments().size(), 10u);
    for (const Segment& segment : plan.segments()) {
      const Eigen::Vector2d corner = world_from_room.Inverse() * segment.from;
      EXPECT_GT(corner.minCoeff(), 0.0);
      EXPECT_LT(corner.x(), size.x());
      EXPECT_LT(corner.y(), size.y());
    }
  }
}

TEST(Furnish, LeavesAnEmptyRoomEmpty) {
  Random random(1);
  FloorPlan plan;
  Furnish(RoomUse::kEmpty, Pose2(), {4.0, 4.0}, &random, &plan);
  EXPECT_TRUE(plan.segments().empty());
}

}  // namespace
}  // namespace loopscope
