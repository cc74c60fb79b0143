// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cassert>
#include <cstring>
#include <filesystem>
#include <utility>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/io/candidate_codec.h"
#include "core/io/compression.h"
#include "core/io/file_error.h"
#include "core/io/number_codec.h"
#include "core/io/recording_creation.h"
#include "core/io/recording_file.h"
#include "core/io/sqlite_run.h"
#include "core/io/step_codec.h"

namespace loopscope {
namespace {

/// [ms] Somebody may read the file while it grows: longer than any reader takes.
constexpr int kBusyTimeout = 60'000;

bool SameBits(const Pose2& a, const Pose2& b) {
  return std::memcmp(&a.translation, &b.translation, sizeof(a.translation)) == 0 &&
         std::memcmp(&a.rotation, &b.rotation, sizeof(a.rotation)) == 0;
}

/// Calls `action` and throws what SQLite or the file system say as FileError.
template <typename Action>
void Guard(const std::string& path, const Action& action) {
  try {
    action();
  } catch (const SQLite::Exception& error) {
    throw FileError(path, std::string("cannot be written: ") + error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    throw FileError(path, "cannot be written: " + error.code().message());
  }
}

}  // namespace

/// The open file, with a statement for each table that grows.
class RecordingWriter::Statements {
 public:
  Statements(const std::string& path, FileLock lock)
      : lock_(std::move(lock)), database_(path, SQLite::OPEN_READWRITE, kBusyTimeout) {
    PrepareForAppending(database_);
    // To make and remove a journal for each step takes as long as to write the step.
    database_.exec("PRAGMA journal_mode = PERSIST");
  }
  ~Statements() {
    try {
      database_.exec("PRAGMA journal_mode = DELETE");
    } catch (const SQLite::Exception&) {
      // An old journal stays beside the recording, and says nothing.
    }
  }

  void Append(const SlamUpdate& update) {
    SQLite::Transaction transaction(database_);
    InsertStep(update);
    if (update.started_submap) InsertSubmap(*update.started_submap);
    if (update.node) InsertNode(*update.node, update.step);
    InsertCandidates(update.candidates);
    if (update.optimization) InsertOptimization(*update.optimization);
    transaction.commit();
    ++num_steps_;
  }

  void Finish(double wall_seconds) {
    database_.exec("PRAGMA synchronous = FULL");
    SQLite::Statement insert(database_, "INSERT INTO timing VALUES ('wall', ?)");
    Run(insert, wall_seconds);
  }

 private:
  void InsertStep(const SlamUpdate& update) {
    const Step& step = update.step;
    ByteWriter poses;
    step_poses_.Put(step, &poses);
    SQLite::bind(insert_step_, num_steps_, static_cast<int>(step.outcome));
    if (step.match_start) insert_step_.bind(3, static_cast<int>(*step.match_start));
    insert_step_.bind(4, poses.bytes().data(), static_cast<int>(poses.bytes().size()));
    if (update.finished_submap) insert_step_.bind(5, update.finished_submap->index);
    insert_step_.bind(6, step.wide_walls ? 1 : 0);
    Run(insert_step_);
  }

  void InsertSubmap(const Submap& submap) {
    const Pose2& pose = submap.local_from_submap;
    Run(insert_submap_, num_submaps_++, num_steps_, submap.first_node.index, pose.x(), pose.y(),
        pose.rotation);
  }

  void InsertNode(const Node& node, const Step& step) {
    assert(node.step == num_steps_);
    const Pose2& pose = node.local_from_base;
    SQLite::bind(insert_node_, step.node->index, node.step, node.first_submap.index,
                 node.num_submaps);
    if (!SameBits(pose, step.local_from_base)) {
      insert_node_.bind(5, pose.x());
      insert_node_.bind(6, pose.y());
      insert_node_.bind(7, pose.rotation);
    }
    Run(insert_node_);
  }

  void InsertCandidates(const std::vector<LoopCandidate>& candidates) {
    if (candidates.empty()) return;
    assert(candidates.front().applied_step == num_steps_);
    ByteWriter bytes;
    PutCandidates(candidates, &bytes);
    RunWithBlob(insert_candidates_, Compress(bytes.bytes()), num_steps_);
  }

  void InsertOptimization(const Optimization& optimization) {
    assert(optimization.step == num_steps_);
    ByteWriter bytes;
    PutPoses(optimization.global_from_submap, last_global_from_submap_, &bytes);
    PutPoses(optimization.global_from_node, last_global_from_node_, &bytes);
    RunWithBlob(insert_optimization_, Compress(bytes.bytes()), num_optimizations_++,
                optimization.step, static_cast<int>(optimization.final),
                optimization.num_iterations, optimization.initial_cost, optimization.final_cost,
                optimization.drift_share.linear, optimization.drift_share.angular);
    last_global_from_submap_ = optimization.global_from_submap;
    last_global_from_node_ = optimization.global_from_node;
  }

  FileLock lock_;
  SQLite::Database database_;
  SQLite::Statement insert_step_{database_, "INSERT INTO step VALUES (?, ?, ?, ?, ?, ?)"};
  SQLite::Statement insert_submap_{database_, "INSERT INTO submap VALUES (?, ?, ?, ?, ?, ?)"};
  SQLite::Statement insert_node_{database_, "INSERT INTO node VALUES (?, ?, ?, ?, ?, ?, ?)"};
  SQLite::Statement insert_candidates_{database_, "INSERT INTO loop_candidates VALUES (?, ?)"};
  SQLite::Statement insert_optimization_{
      database_, "INSERT INTO optimization VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"};
  StepPoseCodec step_poses_;
  int num_steps_ = 0;
  int num_submaps_ = 0;
  int num_optimizations_ = 0;
  std::vector<Pose2> last_global_from_submap_;
  std::vector<Pose2> last_global_from_node_;
};

RecordingWriter::RecordingWriter(const std::string& path, const ScanLog& log,
                                 const Options& options)
    : path_(path) {
  Guard(path_, [&] {
    statements_ = std::make_unique<Statements>(path_, CreateRecording(path_, log, options));
  });
}

RecordingWriter::~RecordingWriter() = default;

void RecordingWriter::Append(const SlamUpdate& update) {
  Guard(path_, [&] { statements_->Append(update); });
}

void RecordingWriter::Finish(double wall_seconds) {
  Guard(path_, [&] {
    statements_->Finish(wall_seconds);
    std::filesystem::remove(KeptRecording(path_));
  });
}

std::string KeptRecording(const std::string& path) { return path + ".before"; }

}  // namespace loopscope
