// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/mapping.h"

#include <utility>

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

}  // namespace

Recording MapLog(const ScanLog& log, const Options& options, int num_threads,
                 RecordingWriter* writer, const MappingObserver& observer) {
  Recording recording(log, options);
  Slam slam(recording.log(), options, num_threads);
  MappingProgress progress;
  progress.num_scans = static_cast<int>(log.scans.size());
  for (int scan = 0; scan < progress.num_scans; ++scan) {
    SlamUpdate update = slam.AddScan(scan);
    if (writer != nullptr) writer->Append(update);
    progress.num_loops += NumAccepted(update.candidates);
    recording.Append(std::move(update));
    progress.num_steps = recording.num_steps();
    progress.num_nodes = static_cast<int>(recording.nodes().size());
    progress.num_submaps = static_cast<int>(recording.submaps().size());
    if (!observer(progress)) break;
  }
  return recording;
}

}  // namespace loopscope
