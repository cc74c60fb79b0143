// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/map_to_file.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "app/cli/progress_bar.h"
#include "app/mapping.h"

namespace loopscope {

namespace {

/// Tells in the end, however that comes, of a finished recording that this run did not replace.
class TellerOfKept {
 public:
  explicit TellerOfKept(const std::string& path) : kept_(KeptRecording(path)) {}
  TellerOfKept(const TellerOfKept&) = delete;
  TellerOfKept& operator=(const TellerOfKept&) = delete;
  ~TellerOfKept() {
    std::error_code ignored;
    if (!std::filesystem::exists(kept_, ignored)) return;
    fmt::print(stderr, "loopscope: the finished run that was there is now {}\n", kept_);
  }

 private:
  std::string kept_;
};

}  // namespace

int DefaultNumThreads() {
  return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

MappedFile MapToFile(const ScanLog& log, const Options& options, int num_threads,
                     const std::string& path) {
  RecordingWriter writer(path, log, options);
  const TellerOfKept teller(path);
  const InterruptGuard guard;
  ProgressBar bar;
  Recording recording = MapLog(log, options, num_threads, &writer,
                               [&](const SlamUpdate&, const MappingProgress& progress) {
                                 bar.Show(progress);
                                 return !InterruptGuard::interrupted();
                               });
  bar.End();
  const double seconds = bar.seconds();
  if (recording.num_steps() == static_cast<int>(log.scans.size())) writer.Finish(seconds);
  if (InterruptGuard::interrupted()) {
    fmt::print(stderr, "loopscope: interrupted; {} holds the scans until then\n", path);
  }
  return {std::move(recording), seconds, InterruptGuard::interrupted()};
}

}  // namespace loopscope
