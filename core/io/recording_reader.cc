// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <future>
#include <sqlite3.h>
#include <utility>
#include <vector>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/io/candidate_codec.h"
#include "core/io/file_error.h"
#include "core/io/number_codec.h"
#include "core/io/recorded_log.h"
#include "core/io/recording_check.h"
#include "core/io/recording_file.h"
#include "core/io/recording_schema.h"
#include "core/io/sqlite_table.h"
#include "core/io/step_codec.h"

namespace loopscope {
namespace {

/// A pair of a node and a submap came up four times at most in all that was ever mapped.
constexpr std::size_t kMaxCandidatesOfPair = 16;

/// Of the poses of an optimization: three varints each, and what is said of the columns.
constexpr std::size_t kMaxBytesOfPose = 30;
constexpr std::size_t kMaxBytesOfColumns = 100;

SQLite::Database OpenDatabase(const std::string& path) {
  // Writing is for SQLite, if a killed process left a journal to be undone.
  SQLite::Database database(path, SQLite::OPEN_READWRITE, /*aBusyTimeoutMs=*/5000);
  sqlite3_limit(database.getHandle(), SQLITE_LIMIT_LENGTH, static_cast<int>(kMaxChunkSize));
  return database;
}

/// Reads a recording from an open file.
class Reader {
 public:
  explicit Reader(const std::string& path) : path_(path), database_(OpenDatabase(path)) {}

  int Version() { return database_.execAndGet("PRAGMA user_version").getInt(); }

  void CheckVersion() {
    const int version = Version();
    if (version > kRecordingSchemaVersion) {
      throw FileError(path_, fmt::format("recording of schema {}, made by a newer Loopscope; "
                                         "expected at most {}",
                                         version, kRecordingSchemaVersion));
    }
  }

  Recording ReadAll() {
    // One transaction, so that a run that goes on beside us does not show in parts.
    const SQLite::Transaction transaction(database_);
    RequireTablesOnly();
    // Half of the work, and never written to again.
    std::future<ScanLog> log = std::async(std::launch::async, [this] {
      SQLite::Database database = OpenDatabase(path_);
      return ReadRecordedLog(path_, database);
    });
    if (Version() < 3) {
      ReadUnpackedSteps();
    } else {
      ReadSteps();
    }
    ReadNodes();
    ReadSubmaps();
    ReadCandidates();
    ReadOptimizations();
    Recording recording(log.get(), ReadRecordedOptions(path_, database_));
    Append(&recording);
    if (next_node_ != nodes_.size() || next_submap_ != submaps_.size() ||
        next_candidates_ != candidates_.size() || next_optimization_ != optimizations_.size()) {
      Fail("there are rows of steps that are not there");
    }
    return recording;
  }

  std::optional<double> WallSeconds() {
    SqliteTable table = Open("timing", "SELECT seconds FROM timing WHERE what = 'wall'");
    return table.Next() ? std::make_optional(table.Double(0)) : std::nullopt;
  }

 private:
  /// A view could be without an end.
  void RequireTablesOnly() {
    constexpr char kCountOthers[] =
        "SELECT count(*) FROM sqlite_master WHERE type NOT IN ('table', 'index')";
    if (database_.execAndGet(kCountOthers).getInt() > 0) Fail("it holds more than tables");
  }

  [[noreturn]] void Fail(const std::string& what) const {
    throw FileError(path_, "damaged data: " + what);
  }

  SqliteTable Open(const std::string& name, const std::string& query) {
    return SqliteTable(database_, path_, name, query);
  }

  void ReadNodes() {
    SqliteTable table = Open("node",
                             "SELECT id, step, first_submap, num_submaps, x, y, rotation FROM node "
                             "ORDER BY id");
    while (table.Next()) {
      if (table.Int(0) != static_cast<int>(nodes_.size())) Fail("nodes are missing");
      const int step = table.Int(1);
      if (step >= static_cast<int>(steps_.size())) {
        Fail("there are nodes of steps that are not there");
      }
      const Pose2 pose = table.IsNull(4) ? steps_[step].first.local_from_base : table.PoseFrom(4);
      nodes_.push_back({step, pose, SubmapId{table.Int(2)}, table.Int(3)});
    }
  }

  void ReadSubmaps() {
    SqliteTable table = Open("submap", "SELECT * FROM submap ORDER BY id");
    while (table.Next()) {
      if (table.Int(0) != static_cast<int>(submaps_.size())) Fail("submaps are missing");
      submaps_.push_back({table.Int(1), {table.PoseFrom(3), NodeId{table.Int(2)}, 0, -1}});
    }
  }

  /// After nodes and submaps, as many as those allow.
  void ReadCandidates() {
    std::size_t num_left = kMaxCandidatesOfPair * nodes_.size() * submaps_.size();
    SqliteTable table = Open("loop_candidates", "SELECT * FROM loop_candidates ORDER BY step");
    while (table.Next()) {
      const std::string where = fmt::format("loop candidates of step {}", table.Int(0));
      const std::string bytes = table.Unpacked(1, kMaxChunkSize, where);
      ByteReader in(bytes, path_, where);
      candidates_.emplace_back(table.Int(0), GetCandidates(table.Int(0), num_left, &in));
      num_left -= candidates_.back().second.size();
      in.ExpectEnd();
    }
  }

  /// After nodes and submaps, of which they have no more poses.
  void ReadOptimizations() {
    const std::string drift_shares =
        Version() < 2 ? "1.0, 1.0" : "linear_drift_share, angular_drift_share";
    SqliteTable table =
        Open("optimization", "SELECT id, step, final, num_iterations, initial_cost, final_cost, " +
                                 drift_shares + ", data FROM optimization ORDER BY id");
    const std::size_t max_size = std::min(
        kMaxChunkSize, kMaxBytesOfColumns + kMaxBytesOfPose * (nodes_.size() + submaps_.size()));
    while (table.Next()) {
      if (table.Int(0) != static_cast<int>(optimizations_.size())) {
        Fail("optimizations are missing");
      }
      Optimization optimization;
      optimization.step = table.Int(1);
      optimization.final = table.Int(2) != 0;
      optimization.num_iterations = table.Int(3);
      optimization.initial_cost = table.Double(4);
      optimization.final_cost = table.Double(5);
      optimization.drift_share = {table.Double(6), table.Double(7)};
      const std::string where = fmt::format("optimization of step {}", optimization.step);
      const std::string bytes = table.Unpacked(8, max_size, where);
      ByteReader in(bytes, path_, where);
      const Optimization* const last = optimizations_.empty() ? nullptr : &optimizations_.back();
      using Poses = std::vector<Pose2>;
      optimization.global_from_submap = GetPoses(last ? last->global_from_submap : Poses(), &in);
      optimization.global_from_node = GetPoses(last ? last->global_from_node : Poses(), &in);
      in.ExpectEnd();
      optimizations_.push_back(std::move(optimization));
    }
  }

  void ReadSteps() {
    StepPoseCodec poses;
    const std::string wide_walls = Version() < 6 ? "0" : "wide_walls";
    SqliteTable table = Open("step", "SELECT id, outcome, match_start, poses, finished_submap, " +
                                         wide_walls + " FROM step ORDER BY id");
    while (table.Next()) {
      Step& step = AddStep(table);
      if (!table.IsNull(2)) step.match_start = table.EnumUpTo(MatchStart::kMotions, 2);
      const std::string where = fmt::format("step {}", table.Int(0));
      ByteReader in(table.Bytes(3), path_, where);
      poses.Get(&in, &step);
      in.ExpectEnd();
      if (!table.IsNull(4)) steps_.back().second = SubmapId{table.Int(4)};
      step.wide_walls = table.Int(5) != 0;
    }
  }

  void ReadUnpackedSteps() {
    SqliteTable table =
        Open("step",
             "SELECT id, outcome, prior_x, prior_y, prior_rotation, correlative_x, correlative_y, "
             "correlative_rotation, x, y, rotation, finished_submap FROM step ORDER BY id");
    while (table.Next()) {
      Step& step = AddStep(table);
      step.local_from_base_prior = table.PoseFrom(2);
      if (!table.IsNull(5)) step.local_from_base_correlative = table.PoseFrom(5);
      step.local_from_base = table.PoseFrom(8);
      if (!table.IsNull(11)) steps_.back().second = SubmapId{table.Int(11)};
    }
  }

  /// With id and outcome, the first columns.
  Step& AddStep(SqliteTable& table) {
    if (table.Int(0) != static_cast<int>(steps_.size())) {
      Fail(fmt::format("step {} is missing", steps_.size()));
    }
    Step step;
    step.outcome = table.EnumUpTo(StepOutcome::kNoReturns, 1);
    return steps_.emplace_back(step, std::nullopt).first;
  }

  void Append(Recording* recording) {
    std::size_t num_candidates = 0;
    for (const auto& [step, some] : candidates_) num_candidates += some.size();
    recording->ReserveCandidates(num_candidates);
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      SlamUpdate update;
      update.step = steps_[i].first;
      update.finished_submap = steps_[i].second;
      TakeRest(static_cast<int>(i), &update);
      if (const auto fault = FaultOf(update, *recording)) {
        Fail(fmt::format("step {} has {}", i, *fault));
      }
      recording->Append(std::move(update));
    }
  }

  /// Moves what the other tables have about `step` into `update`.
  void TakeRest(int step, SlamUpdate* update) {
    if (next_node_ < nodes_.size() && nodes_[next_node_].step == step) {
      update->step.node = NodeId{static_cast<int>(next_node_)};
      update->node = nodes_[next_node_++];
    }
    if (next_submap_ < submaps_.size() && submaps_[next_submap_].first == step) {
      update->started_submap = submaps_[next_submap_++].second;
    }
    if (next_candidates_ < candidates_.size() && candidates_[next_candidates_].first == step) {
      update->candidates = std::move(candidates_[next_candidates_++].second);
    }
    if (next_optimization_ < optimizations_.size() &&
        optimizations_[next_optimization_].step == step) {
      update->optimization = std::move(optimizations_[next_optimization_++]);
    }
  }

  std::string path_;
  SQLite::Database database_;
  std::vector<std::pair<Step, std::optional<SubmapId>>> steps_;  ///< with the submap it finished
  std::vector<Node> nodes_;
  std::vector<std::pair<int, Submap>> submaps_;  ///< with the step in which they were begun
  std::vector<std::pair<int, std::vector<LoopCandidate>>> candidates_;  ///< by applied_step
  std::vector<Optimization> optimizations_;
  std::size_t next_node_ = 0;
  std::size_t next_submap_ = 0;
  std::size_t next_candidates_ = 0;
  std::size_t next_optimization_ = 0;
};

/// Calls action(reader) and throws what SQLite says as FileError.
template <typename Action>
auto WithReader(const std::string& path, const Action& action) {
  std::error_code unreachable;
  if (!std::filesystem::exists(path, unreachable)) {
    throw FileError(path, "cannot be opened: " +
                              (unreachable ? unreachable.message() : std::string("no such file")));
  }
  if (!IsRecording(path)) throw FileError(path, "not a Loopscope recording");
  try {
    Reader reader(path);
    reader.CheckVersion();
    return action(reader);
  } catch (const SQLite::Exception& error) {
    throw FileError(path, std::string("damaged recording: ") + error.what());
  }
}

}  // namespace

bool IsRecording(const std::string& path) {
  // Not asked of SQLite, which would want to settle the journal of a killed process first.
  constexpr std::size_t kApplicationId = 68;
  std::string header(100, '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(header.data(), static_cast<std::streamsize>(header.size()));
  return file.good() && header.compare(0, 16, "SQLite format 3", 16) == 0 &&
         header.compare(kApplicationId, 4, "Loop") == 0;
}

Recording ReadRecording(const std::string& path) {
  return WithReader(path, [](Reader& reader) { return reader.ReadAll(); });
}

std::optional<double> ReadWallSeconds(const std::string& path) {
  return WithReader(path, [](Reader& reader) { return reader.WallSeconds(); });
}

}  // namespace loopscope
