// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <signal.h>
#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/io/carmen_log.h"
#include "core/io/carmen_writer.h"
#include "core/io/recording_file.h"
#include "core/io/recording_hash.h"
#include "tests/support/local_run.h"
#include "tests/support/office_excerpt.h"
#include "tests/support/program.h"
#include "tests/support/small_recording.h"

namespace loopscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Whether `text` is one line that the program says for itself.
bool IsOneLineOfTrouble(const std::string& text) {
  return text.rfind("loopscope: ", 0) == 0 && text.find('\n') + 1 == text.size();
}

TEST(MapCommand, WritesARecordingAndASummary) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(40));
  const ProgramRun run = RunLoopscope(folder, "map a.log -o run.loopscope");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("run.loopscope: 40 of 40 scans, "));
  EXPECT_THAT(run.err, HasSubstr("100 %  40/40 scans"));
  EXPECT_EQ(ReadRecording(folder.Path("run.loopscope")).num_steps(), 40);
  EXPECT_TRUE(ReadWallSeconds(folder.Path("run.loopscope")));
}

TEST(MapCommand, EndsWhereOdometryJumpsOnUntilItIsFartherThanAGridCan) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(40));
  ScanLog log = ReadCarmenLog(folder.Path("a.log"));
  for (int scan = 20; scan < 40; ++scan) JumpOdometry(scan, Pose2(60.0, 60.0, 0.0), &log);
  WriteCarmenLog(folder.Path("jump.log"), log);
  const ProgramRun run = RunLoopscope(folder, "map jump.log -o a.loopscope --preset cartographer");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("loopscope: jump.log: scan 32: a grid of "));
  EXPECT_EQ(ReadRecording(folder.Path("a.loopscope")).num_steps(), 32);
}

TEST(MapCommand, NamesTheRecordingAfterTheLog) {
  const TemporaryFolder folder;
  folder.Write("some.log", OfficeExcerpt(3));
  EXPECT_EQ(RunLoopscope(folder, "map some.log").exit_code, 0);
  EXPECT_TRUE(IsRecording(folder.Path("some.loopscope")));
  folder.Write("2026.11.30.log", OfficeExcerpt(3));
  EXPECT_EQ(RunLoopscope(folder, "map 2026.11.30.log").exit_code, 0);
  EXPECT_TRUE(IsRecording(folder.Path("2026.11.30.loopscope")));
}

TEST(MapCommand, GivesTheSameRecordingForAnyNumberOfThreads) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(150));
  const std::string small = " --set TRAJECTORY_BUILDER_2D.submaps.num_range_data=10";
  ASSERT_EQ(RunLoopscope(folder, "map a.log -o 1.loopscope --threads 1" + small).exit_code, 0);
  ASSERT_EQ(RunLoopscope(folder, "map a.log -o 4.loopscope --threads 4" + small).exit_code, 0);
  const Recording one = ReadRecording(folder.Path("1.loopscope"));
  EXPECT_GT(one.candidates().size(), 10u);
  EXPECT_EQ(HashOfRecording(one), HashOfRecording(ReadRecording(folder.Path("4.loopscope"))));
}

TEST(MapCommand, TakesOptionsFromPresetFileAndAssignments) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(3));
  folder.Write("a.lua",
               "include \"map_builder.lua\"\ninclude \"trajectory_builder.lua\"\n"
               "options = { map_builder = MAP_BUILDER, trajectory_builder = "
               "TRAJECTORY_BUILDER }\nTRAJECTORY_BUILDER_2D.min_range = 0.25\n"
               "return options\n");
  const auto options_of = [&](const std::string& arguments) {
    const ProgramRun run = RunLoopscope(folder, "map a.log -o run.loopscope " + arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return ReadRecording(folder.Path("run.loopscope")).options();
  };
  EXPECT_EQ(options_of("--preset cartographer").pose_graph.optimize_every_n_nodes,
            CartographerPreset().pose_graph.optimize_every_n_nodes);
  EXPECT_EQ(options_of("").pose_graph.optimize_every_n_nodes,
            LoopscopePreset().pose_graph.optimize_every_n_nodes);
  const Options from_file =
      options_of("--options a.lua --set POSE_GRAPH.optimize_every_n_nodes=7 --no-odometry");
  EXPECT_EQ(from_file.trajectory_builder_2d.range.min_range, 0.25);
  EXPECT_EQ(from_file.pose_graph.optimize_every_n_nodes, 7);
  EXPECT_FALSE(from_file.trajectory_builder_2d.use_odometry);
}

TEST(MapCommand, SaysInOneLineWhatIsWrongWithALogAndLeavesFilesAlone) {
  const TemporaryFolder folder;
  const std::string old = folder.Write("run.loopscope", "");
  folder.Write("good.log", OfficeExcerpt(3));
  ASSERT_EQ(RunLoopscope(folder, "map good.log -o run.loopscope").exit_code, 0);
  const std::string before = ContentOf(old);
  folder.Write("empty.log", "");
  folder.Write("binary.log", std::string("\x7f\x45LF\0\x01\xff\n\xfe", 9));
  folder.Write("counts.log", "FLASER 1000000000 1 2 3 0 0 0 0 0 0 1 h 1\nFLASER 5 1\n");
  folder.Write("odometry.log", "ODOM 0 0 0 0 0 0 1 h 1\n");
  folder.Write("cut.log.gz", "\x1f\x8b\x08");
  for (const char* log : {"none.log", "empty.log", "binary.log", "counts.log", "odometry.log",
                          "cut.log.gz", "run.loopscope", "."}) {
    const ProgramRun run = RunLoopscope(folder, std::string("map -o run.loopscope ") + log);
    EXPECT_EQ(run.exit_code, 2) << log;
    EXPECT_TRUE(IsOneLineOfTrouble(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(log));
    EXPECT_EQ(run.out, "");
  }
  EXPECT_EQ(ContentOf(old), before);
}

TEST(MapCommand, SaysInOneLineWhereItCannotWrite) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(3));
  const std::string log = ContentOf(folder.Path("a.log"));
  for (const char* output : {"none/run.loopscope", "a.log", ".", "a.log/run.loopscope"}) {
    const ProgramRun run = RunLoopscope(folder, std::string("map a.log -o ") + output);
    EXPECT_EQ(run.exit_code, 2) << output;
    EXPECT_THAT(run.err, HasSubstr(std::string("loopscope: ") + output + ": ")) << output;
  }
  EXPECT_EQ(ContentOf(folder.Path("a.log")), log);
}

TEST(MapCommand, SaysInOneLineThatTheDiskIsFullAndKeepsWhatWasThere) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(60));
  ASSERT_EQ(RunLoopscope(folder, "map a.log -o run.loopscope").exit_code, 0);
  const std::string before = ContentOf(folder.Path("run.loopscope"));
  const ProgramRun run = RunLoopscope(folder, "map a.log -o run.loopscope", "ulimit -f 8 &&");
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("loopscope: run.loopscope: cannot be written: "));
  EXPECT_EQ(ContentOf(folder.Path("run.loopscope")), before);
}

TEST(MapCommand, RefusesOptionsThatDoNotExistOrDoNotFit) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(3));
  const std::vector<std::pair<std::string, std::string>> mistakes = {
      {"--set TRAJECTORY_BUILDER_2D.max_rnge=3", "TRAJECTORY_BUILDER_2D.max_range"},
      {"--set TRAJECTORY_BUILDER_2D.max_range=-3", "TRAJECTORY_BUILDER_2D.max_range"},
      {"--set TRAJECTORY_BUILDER_2D.max_range", "TRAJECTORY_BUILDER_2D.max_range"},
      {"--options none.lua", "none.lua"},
      {"--preset nonsense", "nonsense"},
      {"--threads 0", "--threads"},
      {"--nonsense", "--nonsense"}};
  for (const auto& [arguments, expected] : mistakes) {
    const ProgramRun run = RunLoopscope(folder, "map a.log " + arguments);
    EXPECT_EQ(run.exit_code, 2) << arguments;
    EXPECT_TRUE(IsOneLineOfTrouble(run.err)) << run.err;
    EXPECT_THAT(run.err, HasSubstr(expected)) << arguments;
  }
  EXPECT_FALSE(std::filesystem::exists(folder.Path("a.loopscope")));
}

/// A run of the whole bundled log that gets a signal once it is on its way, with 90 % to go.
class RunningMap {
 public:
  explicit RunningMap(const std::string& output) {
    int ends[2];
    if (pipe(ends) != 0) std::abort();
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      execl(LOOPSCOPE_BINARY_DIR "/bin/loopscope", "loopscope", "map",
            LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz", "-o", output.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    stderr_ = fdopen(ends[0], "r");
    char line[1000];
    while (fgets(line, sizeof(line), stderr_) != nullptr) {
      if (std::string(line).find("10 %") != std::string::npos) break;
    }
  }
  ~RunningMap() { fclose(stderr_); }

  /// The status that wait gives.
  int EndWith(int signal) {
    kill(process_, signal);
    for (int c = fgetc(stderr_); c != EOF; c = fgetc(stderr_)) rest_ += static_cast<char>(c);
    int status = 0;
    waitpid(process_, &status, 0);
    return status;
  }

  /// What it said after 10 %.
  const std::string& rest() const { return rest_; }

 private:
  pid_t process_;
  FILE* stderr_;
  std::string rest_;
};

TEST(MapCommand, LeavesARecordingThatOpensWhenInterrupted) {
  const TemporaryFolder folder;
  const int status = RunningMap(folder.Path("run.loopscope")).EndWith(SIGINT);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 1);
  const int num_steps = ReadRecording(folder.Path("run.loopscope")).num_steps();
  EXPECT_GE(num_steps, 109);
  EXPECT_LT(num_steps, 1098);
  EXPECT_FALSE(ReadWallSeconds(folder.Path("run.loopscope")));
}

TEST(MapCommand, TellsWhereItKeepsAFinishedRecordingWhenInterrupted) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("run.loopscope");
  const SmallRun run(3);
  RecordingWriter(path, run.log(), CartographerPreset()).Finish(1.0);
  RunningMap map(path);
  map.EndWith(SIGINT);
  EXPECT_THAT(map.rest(),
              HasSubstr("the finished run that was there is now " + path + ".before\n"));
  EXPECT_EQ(ReadWallSeconds(path + ".before"), 1.0);
}

TEST(MapCommand, LeavesARecordingThatOpensWhenKilled) {
  const TemporaryFolder folder;
  const int status = RunningMap(folder.Path("run.loopscope")).EndWith(SIGKILL);
  ASSERT_TRUE(WIFSIGNALED(status));
  EXPECT_GE(ReadRecording(folder.Path("run.loopscope")).num_steps(), 109);
  const ProgramRun info = RunLoopscope(folder, "info run.loopscope");
  EXPECT_EQ(info.exit_code, 0);
  EXPECT_THAT(info.out, HasSubstr("not finished"));
  const ProgramRun render = RunLoopscope(folder, "render run.loopscope --size 320x240");
  EXPECT_EQ(render.exit_code, 0) << render.err;
}

}  // namespace
}  // namespace loopscope
