// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/simulation_files.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "core/evaluation/relations.h"
#include "core/io/carmen_log.h"
#include "core/io/line_reader.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"

namespace loopscope {
namespace {

std::string TextOf(const std::string& path) {
  LineReader reader(path);
  std::string text;
  while (const auto line = reader.Next()) text.append(*line) += '\n';
  return text;
}

TEST(WriteSimulation, WritesLogRelationsAndTruthBesideEachOther) {
  const std::string folder = ::testing::TempDir() + "/write_simulation/";
  std::filesystem::create_directories(folder);
  const Simulation simulation = Simulate(MakeWorld("loop"), {});
  for (const char* end : {".log", ".log.gz"}) {
    const SimulationFiles files = WriteSimulation(folder + "run" + end, simulation);
    EXPECT_EQ(files.log, folder + "run" + end);
    EXPECT_EQ(files.relations, folder + "run.relations");
    EXPECT_EQ(files.ground_truth, folder + "run.tum");
    EXPECT_EQ(ReadCarmenLog(files.log).scans.size(), simulation.log.scans.size());
    const Trajectory truth = ReadTum(files.ground_truth);
    EXPECT_EQ(truth.size(), simulation.ground_truth.size());
    const RelationsError error = EvaluateRelations(ReadRelations(files.relations), truth);
    EXPECT_GT(error.translation.count, 150);
    EXPECT_LT(error.translation.max, 1e-5);
    EXPECT_LT(error.rotation.max, 1e-5);
  }
}

TEST(WriteSimulation, MadeTheBundledLog) {
  const std::string bundled = LOOPSCOPE_SOURCE_DIR "/datasets/office";
  const std::string remade = ::testing::TempDir() + "/office";
  WriteSimulation(remade + ".log.gz", Simulate(MakeWorld("office"), {}));
  for (const char* end : {".log.gz", ".relations", ".tum"}) {
    const std::string text = TextOf(bundled + end);
    EXPECT_GT(text.size(), 1000u) << end;
    EXPECT_TRUE(text == TextOf(remade + end)) << end << " differs: see datasets/README.md";
  }
}

}  // namespace
}  // namespace loopscope
