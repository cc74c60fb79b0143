// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/simulation_writer.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <zlib.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

// Two odometry readings, a scan of `num_beams` beams after the second.
ScanLog SmallLog(const BeamGeometry& beams, std::vector<float> ranges) {
  ScanLog log;
  log.name = "small";
  log.beam_geometries = {beams};
  log.base_from_laser = Pose2(0.5, 0.0, 0.0);
  log.odometry = {{10.0, Pose2()}, {10.25, Pose2(1.0, 2.0, DegreesToRadians(90.0))}};
  log.scans = {{10.25, 0, std::move(ranges), 2}};
  return log;
}

std::string CarmenText(const ScanLog& log) {
  std::ostringstream out;
  WriteCarmenLog(log, out);
  return out.str();
}

TEST(WriteCarmenLog, WritesOldStyleScansWithPosesOfLaserAndRobot) {
  std::vector<float> ranges(181, 1.5f);
  ranges[0] = kInfinity;
  ranges[1] = kNan;
  ranges[2] = 1.23f;
  const BeamGeometry beams{181, DegreesToRadians(-90.0), DegreesToRadians(1.0)};
  const std::string text = CarmenText(SmallLog(beams, ranges));
  EXPECT_THAT(text, HasSubstr("PARAM robot_frontlaser_offset 0.5 simulated 0\n"));
  EXPECT_THAT(text,
              HasSubstr("ODOM 1.000000 2.000000 1.570796 0 0 0 10.250000 simulated 10.250000\n"
                        "FLASER 181 81.91 0 1.23 1.5 1.5 "));
  EXPECT_THAT(text,
              HasSubstr(" 1.5 1.000000 2.500000 1.570796 1.000000 2.000000 1.570796 10.250000 "
                        "simulated 10.250000\n"));
}

TEST(WriteCarmenLog, WritesTheGeometryOfOtherScanners) {
  const BeamGeometry beams{3, DegreesToRadians(-135.0), DegreesToRadians(135.0)};
  EXPECT_THAT(
      CarmenText(SmallLog(beams, {1.0f, 2.0f, 3.0f})),
      HasSubstr("ROBOTLASER1 0 -2.356194490 4.712388980 2.356194490 81.91 0.01 0 3 1 2 3 0 "
                "1.000000 2.500000 1.570796 1.000000 2.000000 1.570796 0 0 0 0 0 10.250000 "));
}

std::vector<std::array<double, 8>> Relations(const Trajectory& trajectory) {
  std::stringstream text;
  WriteRelations(trajectory, text);
  std::vector<std::array<double, 8>> relations;
  std::array<double, 8> line;
  while (text >> line[0] >> line[1] >> line[2] >> line[3] >> line[4] >> line[5] >> line[6] >>
         line[7]) {
    relations.push_back(line);
  }
  return relations;
}

TEST(WriteRelations, TellsTheTruth) {
  const Trajectory truth = Simulate(MakeWorld("loop"), {}).ground_truth;
  const auto relations = Relations(truth);
  EXPECT_GT(relations.size(), 150u);
  for (const auto& [t1, t2, x, y, z, roll, pitch, yaw] : relations) {
    const Pose2 second = PoseAt(truth, t1) * Pose2(x, y, yaw);
    EXPECT_LT((second.translation - PoseAt(truth, t2).translation).norm(), 1e-5);
    EXPECT_NEAR(NormalizeAngle(second.rotation - PoseAt(truth, t2).rotation), 0.0, 1e-5);
    EXPECT_EQ(std::abs(z) + std::abs(roll) + std::abs(pitch), 0.0);
  }
}

TEST(WriteRelations, TiesPlacesThatWereVisitedTwice) {
  const Trajectory truth = Simulate(MakeWorld("loop"), {}).ground_truth;
  int num_revisits = 0;
  for (const auto& relation : Relations(truth)) num_revisits += relation[1] - relation[0] > 30.0;
  EXPECT_GT(num_revisits, 40);
}

TEST(WriteTumTrajectory, WritesTheTurnAsAQuaternion) {
  std::ostringstream text;
  WriteTumTrajectory({{12.5, Pose2(1.0, -2.0, DegreesToRadians(60.0))}}, text);
  EXPECT_EQ(text.str(), "12.500000 1.000000 -2.000000 0 0 0 0.500000000 0.866025404\n");
}

std::string ReadText(const std::string& path) {
  const gzFile file = gzopen(path.c_str(), "rb");  // reads plain files too
  if (!file) return "";
  std::string text;
  char buffer[1 << 16];
  for (int size; (size = gzread(file, buffer, sizeof(buffer))) > 0;) text.append(buffer, size);
  gzclose(file);
  return text;
}

TEST(SaveSimulation, WritesLogRelationsAndTruthBesideEachOther) {
  const std::string folder = ::testing::TempDir() + "/save_simulation/";
  std::filesystem::create_directories(folder);
  const Simulation simulation = Simulate(MakeWorld("loop"), {});
  const SimulationFiles plain = SaveSimulation(simulation, folder + "a.log");
  const SimulationFiles packed = SaveSimulation(simulation, folder + "b.log.gz");
  EXPECT_EQ(plain.relations, folder + "a.relations");
  EXPECT_EQ(packed.relations, folder + "b.relations");
  EXPECT_EQ(packed.ground_truth, folder + "b.tum");
  EXPECT_EQ(ReadText(plain.log), CarmenText(simulation.log));
  EXPECT_EQ(ReadText(packed.log), CarmenText(simulation.log));
  EXPECT_LT(std::filesystem::file_size(packed.log), std::filesystem::file_size(plain.log) / 2);
  EXPECT_THAT(ReadText(packed.relations), StartsWith("1000000000."));
  EXPECT_THAT(ReadText(packed.ground_truth),
              StartsWith("1000000000.000000 3.000000 1.100000 0 0 0"));
}

TEST(SaveSimulation, NamesTheFileThatCannotBeWritten) {
  for (const char* path : {"/nonexistent/folder/x.log", "/nonexistent/folder/x.log.gz"}) {
    try {
      SaveSimulation(Simulation(), path);
      FAIL() << "expected an exception";
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), StartsWith(path));
    }
  }
}

TEST(SaveSimulation, MadeTheBundledLog) {
  const std::string bundled = LOOPSCOPE_SOURCE_DIR "/datasets/office";
  const std::string remade = ::testing::TempDir() + "/office";
  SaveSimulation(Simulate(MakeWorld("office"), {}), remade + ".log.gz");
  for (const char* end : {".log.gz", ".relations", ".tum"}) {
    const std::string text = ReadText(bundled + end);
    EXPECT_GT(text.size(), 1000u) << end;
    EXPECT_TRUE(text == ReadText(remade + end)) << end << " differs: see datasets/README.md";
  }
}

}  // namespace
}  // namespace loopscope
