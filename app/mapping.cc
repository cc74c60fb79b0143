// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/mapping.h"

#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "core/io/file_error.h"
#include "core/slam/slam.h"

namespace loopscope {
namespace {

int NumAccepted(const std::vector<LoopCandidate>& candidates) {
  int num_accepted = 0;
  for (const LoopCandidate& candidate : candidates) {
    num_accepted += candidate.verdict == Verdict::kAccepted ? 1 : 0;
  }
  return num_accepted;
}

/// Throws what the data caused as FileError.
SlamUpdate AddScan(const ScanLog& log, int scan, Slam* slam) {
  try {
    return slam->AddScan(scan);
  } catch (const std::length_error& error) {
    throw FileError(log.name, fmt::format("scan {}: {}", scan, error.what()));
  }
}

}  // namespace

Recording MapLog(const ScanLog& log, const Options& options, int num_threads,
                 RecordingWriter* writer, const MappingObserver& observer) {
  Recording recording(log, options);
  Slam slam(recording.log(), options, num_threads);
  MappingProgress progress;
  progress.num_scans = static_cast<int>(log.scans.size());
  for (int scan = 0; scan < progress.num_scans; ++scan) {
    SlamUpdate update = AddScan(log, scan, &slam);
    if (writer != nullptr) writer->Append(update);
    ++progress.num_steps;
    progress.num_nodes += update.node ? 1 : 0;
    progress.num_submaps += update.started_submap ? 1 : 0;
    progress.num_loops += NumAccepted(update.candidates);
    const bool go_on = observer(update, progress);
    recording.Append(std::move(update));
    if (!go_on) break;
  }
  return recording;
}

}  // namespace loopscope
