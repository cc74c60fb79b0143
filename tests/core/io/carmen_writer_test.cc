// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/carmen_writer.h"

#include <cmath>
#include <filesystem>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/carmen_log.h"
#include "core/io/file_error.h"
#include "core/simulation/simulate.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using ::testing::HasSubstr;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Two odometry readings, and after them a scan.
ScanLog SmallLog(const BeamGeometry& beams, std::vector<float> ranges) {
  ScanLog log;
  log.name = "small";
  log.beam_geometries = {beams};
  log.base_from_laser = Pose2(0.5, 0.0, 0.0);
  log.odometry = {{10.0, Pose2()}, {10.25, Pose2(1.0, 2.0, DegreesToRadians(90.0))}};
  log.scans = {{10.25, 0, std::move(ranges), 2}};
  return log;
}

TEST(CarmenText, HasOldStyleScansWithPosesOfLaserAndRobot) {
  std::vector<float> ranges(181, 1.5f);
  ranges[0] = kInfinity;
  ranges[1] = kNan;
  ranges[2] = 1.23f;
  const BeamGeometry beams{181, DegreesToRadians(-90.0), DegreesToRadians(1.0)};
  const std::string text = CarmenText(SmallLog(beams, ranges));
  EXPECT_THAT(text, HasSubstr("PARAM robot_frontlaser_offset 0.5 loopscope 0\n"));
  EXPECT_THAT(text,
              HasSubstr("ODOM 1.000000 2.000000 1.570796 0 0 0 10.250000 loopscope 10.250000\n"
                        "FLASER 181 81.91 0 1.23 1.5 1.5 "));
  EXPECT_THAT(text,
              HasSubstr(" 1.5 1.000000 2.500000 1.570796 1.000000 2.000000 1.570796 10.250000 "
                        "loopscope 10.250000\n"));
}

TEST(CarmenText, HasTheGeometryOfOtherScanners) {
  const BeamGeometry beams{3, DegreesToRadians(-135.0), DegreesToRadians(135.0)};
  EXPECT_THAT(
      CarmenText(SmallLog(beams, {1.0f, 2.0f, 3.0f})),
      HasSubstr("ROBOTLASER1 0 -2.356194490 4.712388980 2.356194490 81.91 0.01 0 3 1 2 3 0 "
                "1.000000 2.500000 1.570796 1.000000 2.000000 1.570796 0 0 0 0 0 10.250000 "));
}

void ExpectSameLog(const ScanLog& expected, const ScanLog& actual) {
  EXPECT_EQ(actual.base_from_laser, expected.base_from_laser);
  ASSERT_EQ(actual.scans.size(), expected.scans.size());
  for (size_t i = 0; i < expected.scans.size(); ++i) {
    EXPECT_EQ(actual.scans[i].ranges, expected.scans[i].ranges) << i;
    EXPECT_NEAR(actual.scans[i].time, expected.scans[i].time, 1e-6);
    const Pose2 odometry = OdometryOfScan(actual, i)->odom_from_base;
    const Pose2 expected_odometry = OdometryOfScan(expected, i)->odom_from_base;
    EXPECT_LT((odometry.translation - expected_odometry.translation).norm(), 2e-6);
    EXPECT_NEAR(NormalizeAngle(odometry.rotation - expected_odometry.rotation), 0.0, 2e-6);
  }
  ASSERT_EQ(actual.beam_geometries.size(), 1u);
  const BeamGeometry& beams = actual.beam_geometries[0];
  EXPECT_EQ(beams.num_beams, expected.beam_geometries[0].num_beams);
  EXPECT_NEAR(beams.first_angle, expected.beam_geometries[0].first_angle, 1e-8);
  EXPECT_NEAR(beams.angle_increment, expected.beam_geometries[0].angle_increment, 1e-8);
}

class WriteCarmenLogOf : public ::testing::TestWithParam<BeamGeometry> {};

INSTANTIATE_TEST_SUITE_P(
    Scanners, WriteCarmenLogOf,
    ::testing::Values(BeamGeometry{180, DegreesToRadians(-90.0), DegreesToRadians(1.0)},
                      BeamGeometry{361, DegreesToRadians(-90.0), DegreesToRadians(0.5)},
                      BeamGeometry{541, DegreesToRadians(-135.0), DegreesToRadians(0.5)},
                      BeamGeometry{360, DegreesToRadians(-180.0), DegreesToRadians(1.0)}));

TEST_P(WriteCarmenLogOf, IsReadBackAsItWas) {
  SimulationOptions options;
  options.scan_period = 1.0;
  options.lidar.beams = GetParam();
  options.lidar.max_range = 15.0;
  const ScanLog log = Simulate(MakeWorld("loop"), options).log;
  const TemporaryFolder folder;
  for (const char* name : {"round_trip.log", "round_trip.log.gz"}) {
    const std::string path = folder.Path(name);
    WriteCarmenLog(path, log);
    ExpectSameLog(log, ReadCarmenLog(path));
  }
}

TEST(WriteCarmenLog, PacksIfTheNameEndsInGz) {
  const ScanLog log = SmallLog({181, DegreesToRadians(-90.0), DegreesToRadians(1.0)},
                               std::vector<float>(181, 1.5f));
  const TemporaryFolder folder;
  const std::string plain = folder.Path("plain.log");
  const std::string packed = folder.Path("packed.log.gz");
  WriteCarmenLog(plain, log);
  WriteCarmenLog(packed, log);
  EXPECT_EQ(std::filesystem::file_size(plain), CarmenText(log).size());
  EXPECT_LT(std::filesystem::file_size(packed), CarmenText(log).size() / 2);
}

TEST(WriteCarmenLog, NamesTheFileThatCannotBeWritten) {
  try {
    WriteCarmenLog("/nonexistent/folder/x.log", ScanLog());
    FAIL() << "expected an exception";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith("/nonexistent/folder/x.log: "));
  }
}

}  // namespace
}  // namespace loopscope
