// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_file.h"

#include <chrono>
#include <filesystem>
#include <future>
#include <random>
#include <signal.h>
#include <thread>
#include <unistd.h>

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include "core/io/file_error.h"
#include "core/io/recording_hash.h"
#include "tests/support/small_recording.h"
#include "tests/support/small_recording_file.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

std::vector<std::string> FilesIn(const std::string& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(RecordingFile, HoldsARunBitForBit) {
  const TemporaryFolder folder;
  for (const int num_scans : {1, 30, 333}) {
    const SmallRun run(num_scans);
    Write(folder.Path("a.loopscope"), run);
    EXPECT_EQ(HashOfRecording(ReadRecording(folder.Path("a.loopscope"))),
              HashOfRecording(run.ToRecording()))
        << num_scans;
  }
}

TEST(RecordingFile, HoldsTheOptions) {
  const TemporaryFolder folder;
  Options options = LoopscopePreset();
  options.trajectory_builder_2d.use_odometry = false;
  options.trajectory_builder_2d.voxel_filter_size = 0.1 + 0.2;
  options.pose_graph.optimize_every_n_nodes = 17;
  const RecordingWriter writer(folder.Path("a.loopscope"), SmallRun(1).log(), options);
  const Options read = ReadRecording(folder.Path("a.loopscope")).options();
  EXPECT_FALSE(read.trajectory_builder_2d.use_odometry);
  EXPECT_EQ(read.trajectory_builder_2d.voxel_filter_size, 0.1 + 0.2);
  EXPECT_EQ(read.pose_graph.optimize_every_n_nodes, 17);
}

TEST(RecordingFile, IsOneFileAtEveryStep) {
  const TemporaryFolder folder;
  const SmallRun run(30);
  auto writer = std::make_unique<RecordingWriter>(folder.Path("a.loopscope"), run.log(),
                                                  CartographerPreset());
  for (int step = 0; step < 30; ++step) {
    EXPECT_EQ(ReadRecording(folder.Path("a.loopscope")).num_steps(), step);
    writer->Append(run.updates()[step]);
    std::filesystem::copy_file(folder.Path("a.loopscope"), folder.Path("copy.loopscope"));
    EXPECT_EQ(ReadRecording(folder.Path("copy.loopscope")).num_steps(), step + 1);
    std::filesystem::remove(folder.Path("copy.loopscope"));
  }
  writer.reset();
  EXPECT_THAT(FilesIn(folder.Path("")), testing::ElementsAre("a.loopscope"));
}

TEST(RecordingFile, GrowsAsSoonAsAReaderIsDone) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const SmallRun run(2);
  RecordingWriter writer(path, run.log(), CartographerPreset());
  std::promise<void> is_reading;
  const auto reader = std::async(std::launch::async, [&] {
    SQLite::Database database(path);
    const SQLite::Transaction transaction(database);
    database.execAndGet("SELECT count(*) FROM step");
    is_reading.set_value();
    std::this_thread::sleep_for(std::chrono::milliseconds(50));
  });
  is_reading.get_future().wait();
  writer.Append(run.updates()[0]);
  reader.wait();
  EXPECT_EQ(ReadRecording(path).num_steps(), 1);
}

TEST(RecordingFile, KnowsHowLongAFinishedRunTook) {
  const TemporaryFolder folder;
  RecordingWriter writer(folder.Path("a.loopscope"), SmallRun(1).log(), CartographerPreset());
  EXPECT_FALSE(ReadWallSeconds(folder.Path("a.loopscope")));
  writer.Finish(12.5);
  EXPECT_EQ(ReadWallSeconds(folder.Path("a.loopscope")), 12.5);
}

TEST(RecordingFile, ShowsAllFinishedStepsAfterKillAtAnyMoment) {
  const SmallRun run(300);
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    const TemporaryFolder folder;
    const std::string path = folder.Path("a.loopscope");
    int pipe_ends[2];
    ASSERT_EQ(pipe(pipe_ends), 0);
    const pid_t child = fork();
    if (child == 0) {
      RecordingWriter writer(path, run.log(), CartographerPreset());
      for (const SlamUpdate& update : run.updates()) {
        writer.Append(update);
        if (write(pipe_ends[1], "x", 1) != 1) _exit(1);
      }
      pause();
    }
    close(pipe_ends[1]);
    const int num_awaited = 1 + static_cast<int>(random() % 250);
    char byte = 0;
    for (int i = 0; i < num_awaited; ++i) ASSERT_EQ(read(pipe_ends[0], &byte, 1), 1);
    usleep(random() % 300);
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    int num_told = num_awaited;
    while (read(pipe_ends[0], &byte, 1) == 1) ++num_told;
    close(pipe_ends[0]);

    const Recording recording = ReadRecording(path);
    EXPECT_GE(recording.num_steps(), num_told);
    EXPECT_LE(recording.num_steps(), num_told + 1);
    Recording expected(run.log(), CartographerPreset());
    for (int i = 0; i < recording.num_steps(); ++i) expected.Append(run.updates()[i]);
    EXPECT_EQ(HashOfRecording(recording), HashOfRecording(expected));
  }
}

TEST(RecordingFile, ReplacesARecording) {
  const TemporaryFolder folder;
  Write(folder.Path("a.loopscope"), SmallRun(30));
  Write(folder.Path("a.loopscope"), SmallRun(12, 2), 5);
  EXPECT_EQ(ReadRecording(folder.Path("a.loopscope")).num_steps(), 5);
  EXPECT_THAT(FilesIn(folder.Path("")), testing::ElementsAre("a.loopscope"));
}

TEST(RecordingFile, KeepsAFinishedRecordingUntilTheOneInItsPlaceIsFinished) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const std::string kept = folder.Path("a.loopscope.before");
  const SmallRun run(3);
  RecordingWriter(path, run.log(), CartographerPreset()).Finish(1.0);
  const std::string finished = ContentOf(path);
  for (int attempt = 0; attempt < 2; ++attempt) {
    Write(path, run);
    EXPECT_EQ(ContentOf(kept), finished);
    EXPECT_EQ(ReadRecording(path).num_steps(), 3);
  }
  RecordingWriter(path, run.log(), CartographerPreset()).Finish(2.0);
  EXPECT_FALSE(std::filesystem::exists(kept));
  EXPECT_EQ(ReadWallSeconds(path), 2.0);
}

TEST(RecordingFile, KeepsADamagedRecordingAsAFinishedOne) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const SmallRun run(3);
  Write(path, run);
  std::string damaged = ContentOf(path);
  damaged.replace(100, 3996, std::string(3996, '\xff'));  // the rest of the first page
  folder.Write("a.loopscope", damaged);
  Write(path, run);
  EXPECT_EQ(ReadRecording(path).num_steps(), 3);
  EXPECT_EQ(ContentOf(path + ".before"), damaged);
}

TEST(RecordingFile, DoesNotTakeOverTheJournalOfTheRecordingItReplaces) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  Write(path, SmallRun(30));
  const pid_t child = fork();
  if (child == 0) {
    SQLite::Database database(path, SQLite::OPEN_READWRITE);
    database.exec(
        "PRAGMA synchronous = OFF; PRAGMA cache_size = 1; BEGIN; "
        "UPDATE step SET outcome = 1; UPDATE scan_chunk SET data = zeroblob(100000)");
    kill(getpid(), SIGKILL);
  }
  waitpid(child, nullptr, 0);
  ASSERT_TRUE(std::filesystem::exists(path + "-journal"));
  const SmallRun run(12, 2);
  Write(path, run);
  EXPECT_EQ(HashOfRecording(ReadRecording(path)), HashOfRecording(run.ToRecording()));
}

TEST(RecordingFile, LeavesARecordingAloneIfItCannotBegin) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  Write(path, SmallRun(30));
  const std::string before = ContentOf(path);
  std::filesystem::create_directories(path + ".part/in the way");
  EXPECT_THAT(MessageOf([&] { Write(path, SmallRun(3)); }), HasSubstr("cannot be written"));
  EXPECT_EQ(ContentOf(path), before);
}

TEST(RecordingFile, LeavesOtherFilesAlone) {
  const TemporaryFolder folder;
  const std::string path = folder.Write("run.log", "FLASER ...");
  EXPECT_EQ(MessageOf([&] { Write(path, SmallRun(3)); }),
            path + ": exists and is no recording; expected a new file, or one to replace");
  EXPECT_EQ(ContentOf(path), "FLASER ...");
  EXPECT_THAT(MessageOf([&] { Write(folder.Path(""), SmallRun(3)); }), HasSubstr("no recording"));
}

TEST(RecordingFile, RemovesAJournalThatItsRecordingLeft) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  folder.Write("a.loopscope-journal", "of a recording that was removed");
  Write(path, SmallRun(3));
  EXPECT_EQ(ReadRecording(path).num_steps(), 3);
  EXPECT_THAT(FilesIn(folder.Path("")), testing::ElementsAre("a.loopscope"));
}

TEST(RecordingFile, IsNotReplacedWhileItIsWritten) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const SmallRun run(3);
  const auto make_writer = [&] {
    return std::make_unique<RecordingWriter>(path, run.log(), CartographerPreset());
  };
  auto writer = make_writer();
  writer->Append(run.updates()[0]);
  EXPECT_EQ(MessageOf([&] { make_writer(); }),
            path + ": is being written by another run; expected it to end first");
  writer->Append(run.updates()[1]);
  EXPECT_EQ(ReadRecording(path).num_steps(), 2);
  writer.reset();
  EXPECT_THAT(FilesIn(folder.Path("")), testing::ElementsAre("a.loopscope"));
  writer = make_writer();
  EXPECT_EQ(ReadRecording(path).num_steps(), 0);
}

TEST(RecordingFile, ThrowsOneLineWhereThereIsNoFolder) {
  const TemporaryFolder folder;
  EXPECT_EQ(MessageOf([&] { Write(folder.Path("none/a.loopscope"), SmallRun(3)); }),
            folder.Path("none/a.loopscope") + ": cannot be written: No such file or directory");
}

TEST(RecordingFile, ThrowsIfTheFileIsNoRecording) {
  const TemporaryFolder folder;
  const std::string database = folder.Path("other.db");
  SQLite::Database(database, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("CREATE TABLE a (b)");
  for (const std::string& path :
       {folder.Write("empty", ""), folder.Write("text", "FLASER 1 2"), database, folder.Path("")}) {
    EXPECT_EQ(MessageOf([&] { ReadRecording(path); }), path + ": not a Loopscope recording");
  }
  EXPECT_THAT(MessageOf([&] { ReadRecording(folder.Path("none")); }), HasSubstr("no such file"));
}

TEST(RecordingFile, ThrowsIfItIsInconsistent) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const std::vector<std::pair<std::string, std::string>> damages = {
      {"DELETE FROM step WHERE id = 2", "step 2 is missing"},
      {"DELETE FROM step WHERE id = 3", "step 3 is missing"},
      {"DELETE FROM step WHERE id = 29", "steps that are not there"},
      {"DELETE FROM step WHERE id = 28 OR id = 29", "steps that are not there"},
      {"UPDATE step SET outcome = 7 WHERE id = 3", "table step: column outcome"},
      {"UPDATE step SET match_start = 6 WHERE id = 3", "table step: column match_start"},
      {"UPDATE step SET poses = x'' WHERE id = 2", "step 2"},
      {"UPDATE step SET poses = x'00' WHERE id = 2", "step 2"},
      {"UPDATE step SET poses = poses || x'00' WHERE id = 2", "step 2"},
      {"UPDATE step SET poses = x'00' || zeroblob(40) || x'000000000000f07f' WHERE id = 2",
       "a pose that is not finite"},
      {"UPDATE step SET finished_submap = 99 WHERE id = 3", "finished submap"},
      {"UPDATE node SET first_submap = 99 WHERE id = 3", "in submaps that are not there"},
      {"UPDATE node SET num_submaps = 3 WHERE id = 3", "in submaps that are not there"},
      {"UPDATE node SET first_submap = 0, num_submaps = 1 WHERE id = 15", "in the last submaps"},
      {"UPDATE step SET finished_submap = 1 WHERE id = 15", "finished submap"},
      {"UPDATE node SET step = 4 WHERE id = 2", "step 6 has a submap"},
      {"DELETE FROM node WHERE id = 3", "nodes are missing"},
      {"UPDATE submap SET first_node = 7 WHERE id = 0", "misses some before it"},
      {"DELETE FROM submap WHERE id = 1", "submaps are missing"},
      {"UPDATE loop_candidates SET step = 4 WHERE step = 9", "damaged data"},
      {"UPDATE loop_candidates SET data = zeroblob(100)", "loop candidates of step"},
      {"DELETE FROM node; DELETE FROM submap", "more loop candidates"},
      {"DELETE FROM optimization WHERE id = 1", "optimizations are missing"},
      {"UPDATE optimization SET data = x'00'", "optimization of step"},
      {"DELETE FROM log", "the log is missing"},
      {"UPDATE log SET num_scans = 31", "scans or odometry are missing"},
      {"DELETE FROM beam_geometry WHERE id = 1", "a scan without beams"},
      {"UPDATE beam_geometry SET num_beams = 4", "wrong number of ranges"},
      {"UPDATE scan_chunk SET first_scan = 5", "some before are missing"},
      {"UPDATE scan_chunk SET data = zeroblob(100)", "scan_chunk 0"},
      {"UPDATE option SET value = 'x' WHERE key LIKE '%num_range_data'", "an option"},
      {"UPDATE option SET key = 'POSE_GRAPH.nonsense' WHERE key LIKE '%num_range_data'",
       "an option"},
      {"DROP TABLE submap", "no such table"},
      {"ALTER TABLE step RENAME TO steps; CREATE VIEW step AS SELECT * FROM steps",
       "more than tables"},
  };
  for (const auto& [damage, expected] : damages) {
    Write(path, SmallRun(30));
    Execute(path, damage);
    const std::string message = MessageOf([&] { ReadRecording(path); });
    EXPECT_THAT(message, HasSubstr(expected)) << damage;
    EXPECT_THAT(message, testing::StartsWith(path)) << damage;
    EXPECT_EQ(message.find('\n'), std::string::npos) << damage;
  }
}

TEST(RecordingFile, OfDamagedBytesIsReadOrThrowsFileError) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  Write(path, SmallRun(60));
  const std::string whole = ContentOf(path);
  std::mt19937 random(1);
  int num_thrown = 0;
  for (int i = 0; i < 300; ++i) {
    std::string damaged = whole;
    if (i % 3 == 0) damaged.resize(100 + random() % whole.size());
    for (unsigned j = 0; j <= random() % 8; ++j) {
      damaged[random() % damaged.size()] = static_cast<char>(random());
    }
    folder.Write("a.loopscope", damaged);
    try {
      ReadRecording(path);
    } catch (const FileError&) {
      ++num_thrown;
    }
  }
  EXPECT_GT(num_thrown, 100);
}

TEST(RecordingFile, AStepThatCannotBeWrittenThrowsAndLeavesThoseBefore) {
  const TemporaryFolder folder;
  const std::string path = folder.Path("a.loopscope");
  const SmallRun run(30);
  RecordingWriter writer(path, run.log(), CartographerPreset());
  writer.Append(run.updates()[0]);
  Execute(path, "CREATE TRIGGER full BEFORE INSERT ON step BEGIN SELECT RAISE(ABORT, 'full'); END");
  EXPECT_EQ(MessageOf([&] { writer.Append(run.updates()[1]); }),
            path + ": cannot be written: full");
  Execute(path, "DROP TRIGGER full");
  EXPECT_EQ(ReadRecording(path).num_steps(), 1);
}

}  // namespace
}  // namespace loopscope
