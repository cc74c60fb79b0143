// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/program.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/recording_file.h"
#include "render/picture.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

constexpr const char* kCommands[] = {"map",   "info",     "render", "search",   "why",
                                     "loops", "evaluate", "export", "simulate", "demo"};

TEST(Program, HelpListsAllCommands) {
  const TemporaryFolder folder;
  const ProgramRun run = RunLoopscope(folder, "--help");
  EXPECT_EQ(run.exit_code, 0);
  for (const char* command : kCommands) {
    EXPECT_THAT(run.out, HasSubstr(std::string("\n  ") + command + " "));
    EXPECT_EQ(RunLoopscope(folder, std::string(command) + " --help").exit_code, 0) << command;
  }
}

TEST(Program, BadUsageIsOneLineAndExitCodeTwo) {
  const TemporaryFolder folder;
  for (const char* arguments : {"", "nonsense", "--nonsense", "map", "render", "simulate",
                                "why run.loopscope --node 1", "loops a b"}) {
    const ProgramRun run = RunLoopscope(folder, arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_EQ(run.out, "") << arguments;
    EXPECT_EQ(run.err.find("loopscope: "), 0u) << run.err;
    EXPECT_EQ(run.err.find('\n') + 1, run.err.size()) << run.err;
  }
}

TEST(Program, SendsToTheHelpOfTheCommand) {
  const TemporaryFolder folder;
  EXPECT_THAT(RunLoopscope(folder, "--nonsense").err, HasSubstr("(see loopscope --help)"));
  EXPECT_THAT(RunLoopscope(folder, "why run.loopscope --node 1").err,
              HasSubstr("(see loopscope why --help)"));
}

TEST(Program, SaysThatItCannotPrint) {
  const TemporaryFolder folder;
  const ProgramRun run = RunLoopscope(folder, "info '" LOOPSCOPE_SOURCE_DIR
                                              "/datasets/office.log.gz' > /dev/full; "
                                              "echo $?");
  EXPECT_EQ(run.out, "2\n");
}

TEST(Program, SimulateWritesALogWithItsTruth) {
  const TemporaryFolder folder;
  for (const char* name : {"a.log", "b.log.gz", "c.log"}) {
    const std::string seed = name[0] == 'c' ? " --seed 2" : "";
    const ProgramRun run =
        RunLoopscope(folder, std::string("simulate --world loop -o ") + name + seed);
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_THAT(run.out, HasSubstr(name));
  }
  EXPECT_EQ(ContentOf(folder.Path("a.tum")), ContentOf(folder.Path("b.tum")));
  EXPECT_EQ(ContentOf(folder.Path("a.relations")), ContentOf(folder.Path("b.relations")));
  EXPECT_NE(ContentOf(folder.Path("a.log")), ContentOf(folder.Path("c.log")));
  EXPECT_EQ(RunLoopscope(folder, "info b.log.gz").exit_code, 0);
}

TEST(Program, SimulateRefusesWhatItCannotDo) {
  const TemporaryFolder folder;
  EXPECT_EQ(RunLoopscope(folder, "simulate --world nonsense -o a.log").exit_code, 2);
  EXPECT_EQ(RunLoopscope(folder, "simulate --scan-period -1 -o a.log").exit_code, 2);
  const ProgramRun run = RunLoopscope(folder, "simulate --world loop -o none/a.log");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("none/a.log: cannot be written"));
}

TEST(Program, DemoLeavesAllOfItInAFolder) {
  const TemporaryFolder folder;
  const ProgramRun run = RunLoopscope(folder, "demo");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, HasSubstr("In " + std::filesystem::canonical(folder.Path("demo")).string()));
  EXPECT_EQ(ReadRecording(folder.Path("demo/office.loopscope")).num_steps(), 1098);
  for (const char* name : {"map.pgm", "map.yaml", "trajectory.tum", "graph.g2o"}) {
    EXPECT_GT(std::filesystem::file_size(folder.Path(std::string("demo/") + name)), 100u) << name;
  }
  for (const char* view : {"map", "submap", "update", "match", "search", "graph"}) {
    EXPECT_EQ(ReadPng(folder.Path(std::string("demo/") + view + ".png")).width, 1280) << view;
  }
}

}  // namespace
}  // namespace loopscope
