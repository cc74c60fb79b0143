// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include <SQLiteCpp/SQLiteCpp.h>

#include "core/io/recording_file.h"
#include "tests/support/small_recording.h"

namespace loopscope {

/// Writes the first `num_steps` of a run; all by default.
inline void Write(const std::string& path, const SmallRun& run, int num_steps = 1 << 30) {
  RecordingWriter writer(path, run.log(), CartographerPreset());
  for (const SlamUpdate& update : run.updates()) {
    if (num_steps-- > 0) writer.Append(update);
  }
}

/// Changes a recording as its writer never does.
inline void Execute(const std::string& path, const std::string& sql) {
  SQLite::Database(path, SQLite::OPEN_READWRITE).exec(sql);
}

}  // namespace loopscope
