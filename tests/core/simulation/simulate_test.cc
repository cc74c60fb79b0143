// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulate.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::vector<std::vector<float>> AllRanges(const Simulation& simulation) {
  std::vector<std::vector<float>> ranges;
  for (const LaserScan& scan : simulation.log.scans) ranges.push_back(scan.ranges);
  return ranges;
}

Pose2 LastOdometry(const Simulation& simulation) {
  return simulation.log.odometry.back().odom_from_base;
}

TEST(Simulate, GivesTheSameLogForTheSameSeed) {
  const World world = MakeWorld("loop");
  const Simulation a = Simulate(world, {});
  const Simulation b = Simulate(world, {});
  EXPECT_EQ(AllRanges(a), AllRanges(b));
  EXPECT_EQ(LastOdometry(a), LastOdometry(b));
}

TEST(Simulate, ChangesTheNoiseAndNotTheDriveWithTheSeed) {
  const World world = MakeWorld("loop");
  SimulationOptions options;
  const Simulation a = Simulate(world, options);
  options.seed = 2;
  const Simulation b = Simulate(world, options);
  EXPECT_NE(AllRanges(a), AllRanges(b));
  EXPECT_NE(LastOdometry(a), LastOdometry(b));
  EXPECT_EQ(a.ground_truth.back().map_from_base, b.ground_truth.back().map_from_base);
}

TEST(Simulate, ChangesOneSensorWithoutTheOther) {
  const World world = MakeWorld("loop");
  const Simulation usual = Simulate(world, {});
  SimulationOptions other_odometry;
  other_odometry.wheel_odometry.distance_noise *= 2.0;
  EXPECT_EQ(AllRanges(Simulate(world, other_odometry)), AllRanges(usual));
  EXPECT_NE(LastOdometry(Simulate(world, other_odometry)), LastOdometry(usual));
  SimulationOptions other_lidar;
  other_lidar.lidar.beams.num_beams /= 2;
  EXPECT_EQ(LastOdometry(Simulate(world, other_lidar)), LastOdometry(usual));
}

TEST(Simulate, StampsEachScanAsTheOdometryReadingBeforeIt) {
  const Simulation simulation = Simulate(MakeWorld("loop"), {});
  const ScanLog& log = simulation.log;
  ASSERT_GT(log.scans.size(), 100u);
  for (size_t i = 0; i < log.scans.size(); ++i) {
    ASSERT_TRUE(OdometryOfScan(log, i));
    EXPECT_EQ(OdometryOfScan(log, i)->time, log.scans[i].time);
    EXPECT_NEAR(log.scans[i].time, 1.0e9 + 0.2 * i, 1e-5);
  }
}

TEST(Simulate, KnowsTheTruthAtEveryStamp) {
  const Simulation simulation = Simulate(MakeWorld("loop"), {});
  ASSERT_EQ(simulation.ground_truth.size(), simulation.log.odometry.size());
  for (size_t i = 0; i < simulation.ground_truth.size(); ++i) {
    EXPECT_EQ(simulation.ground_truth[i].time, simulation.log.odometry[i].time);
  }
}

TEST(Simulate, MountsTheScannerInFrontOfTheRobot) {
  World world;
  world.plan.AddPolygon({{-1.0, -1.0}, {9.0, -1.0}, {9.0, 1.0}, {-1.0, 1.0}});
  world.route = {{0.0, 0.0}, {5.0, 0.0}};
  SimulationOptions options;
  options.laser_offset = 0.25;
  options.lidar.range_noise = 0.0;
  options.lidar.dropout_probability = 0.0;
  const Simulation simulation = Simulate(world, options);
  EXPECT_EQ(simulation.log.base_from_laser, Pose2(0.25, 0.0, 0.0));
  EXPECT_FLOAT_EQ(simulation.log.scans.front().ranges[180], 8.75f);
}

class SimulateEveryWorld : public ::testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Worlds, SimulateEveryWorld, ::testing::ValuesIn(WorldNames()),
                         [](const auto& world) { return world.param; });

TEST_P(SimulateEveryWorld, OdometryAloneIsOffByMetres) {
  const Simulation simulation = Simulate(MakeWorld(GetParam()), {});
  const Trajectory& truth = simulation.ground_truth;
  double worst = 0.0;
  for (size_t i = 0; i < truth.size(); ++i) {
    const Pose2 world_from_odometry =
        truth.front().map_from_base * simulation.log.odometry[i].odom_from_base;
    worst = std::max(worst,
                     (world_from_odometry.translation - truth[i].map_from_base.translation).norm());
  }
  EXPECT_GT(worst, 2.0);
}

TEST(Simulate, NamesTheOptionThatIsOutOfRange) {
  SimulationOptions options;
  options.lidar.max_range = 100.0;
  try {
    Simulate(MakeWorld("loop"), options);
    FAIL() << "expected an exception";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("lidar.max_range = 100"), HasSubstr("0.1 to 80")));
  }
}

TEST(Simulate, RefusesWhatWouldNotEnd) {
  SimulationOptions at_rest;
  at_rest.drive.acceleration = 0.0;
  EXPECT_THROW(Simulate(MakeWorld("loop"), at_rest), std::invalid_argument);
  SimulationOptions no_number;
  no_number.wheel_odometry.distance_scale = std::nan("");
  EXPECT_THROW(Simulate(MakeWorld("loop"), no_number), std::invalid_argument);
}

}  // namespace
}  // namespace loopscope
