// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

#include "core/io/recording_file.h"
#include "core/slam/recording.h"

namespace loopscope {

/// How far the mapping of a log has come.
struct MappingProgress {
  int num_steps = 0;  ///< scans mapped
  int num_scans = 0;  ///< scans of the log
  int num_nodes = 0;
  int num_submaps = 0;
  int num_loops = 0;  ///< accepted
};

/// Told after every scan what it caused; mapping stops there if it says no.
using MappingObserver = std::function<bool(const SlamUpdate&, const MappingProgress&)>;

/// Maps a log and writes the recording, if `writer` is given, while it comes about. `num_threads`
/// >= 1 searches run in the background. Throws FileError if the recording cannot be
/// written, or if a scan leads so far that its submap does not fit in memory.
Recording MapLog(const ScanLog& log, const Options& options, int num_threads,
                 RecordingWriter* writer, const MappingObserver& observer);

}  // namespace loopscope
