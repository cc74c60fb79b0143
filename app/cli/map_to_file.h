// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/slam/recording.h"

namespace loopscope {

struct MappedFile {
  Recording recording;
  double seconds = 0.0;  ///< that it took
  bool was_interrupted = false;
};

/// One for each core.
int DefaultNumThreads();

/// Maps `log` and records it in `path`, with a bar on stderr, until its end or Ctrl-C, of which it
/// tells. Throws FileError as MapLog does.
MappedFile MapToFile(const ScanLog& log, const Options& options, int num_threads,
                     const std::string& path);

}  // namespace loopscope
