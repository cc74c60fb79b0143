// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/slam/recording.h"

namespace loopscope {

// A recording as one SQLite file, *.loopscope; its tables are described in recording_schema.cc.
// Every step is a transaction of its own, so a process may be killed at any moment: the file still
// opens, and holds all steps that were finished. (While it is written a *-journal is beside it,
// which belongs to it in the middle of a step; between two steps the file alone is the recording.)

/// Writes a recording while it comes about.
class RecordingWriter {
 public:
  /// Begins the recording of a run of `options` on `log`. A recording at `path` is replaced, at the
  /// moment in which the new one is complete but for its steps; until then it is written to
  /// `path`.part. If the other went to its end, or is damaged, it is kept as KeptRecording until
  /// this one does. Throws FileError if that cannot be done, if another one is still being written
  /// there, or if something else than a recording is at `path`; then that is left as it was.
  RecordingWriter(const std::string& path, const ScanLog& log, const Options& options);
  ~RecordingWriter();

  /// Adds what the next scan caused. Throws FileError if it cannot be written; the steps before
  /// stay.
  void Append(const SlamUpdate& update);

  /// To be called after the last step of a run that went to its end; sees to it that all is on
  /// disk, and removes the KeptRecording. `wall_seconds` is how long it took: no result depends on
  /// it.
  void Finish(double wall_seconds);

 private:
  class Statements;

  std::string path_;
  std::unique_ptr<Statements> statements_;
};

/// Where a finished recording is kept while another is written in its place, until that is
/// finished, too: `path`.before.
std::string KeptRecording(const std::string& path);

/// Whether the file at `path` says that it is a recording. False if there is none.
bool IsRecording(const std::string& path);

/// Reads a recording, finished or not. Throws FileError if there is none at `path`, if it is of a
/// newer schema, or damaged: what is returned is consistent.
Recording ReadRecording(const std::string& path);

/// How long the run took [s]; nothing if it was not finished. Throws as ReadRecording does.
std::optional<double> ReadWallSeconds(const std::string& path);

}  // namespace loopscope
