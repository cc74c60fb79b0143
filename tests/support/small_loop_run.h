// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"

namespace loopscope {

/// The small loop, mapped once for all tests of a program.
inline const Recording& SmallLoopRun() {
  static const Recording* const recording =
      new Recording(MapLog(SimulateSmallLoop().log, SmallLoopOptions()));
  return *recording;
}

inline MapState LastState(const Recording& recording) {
  return StateAfterStep(recording, recording.num_steps() - 1);
}

/// Index of the first candidate with this verdict; the recording must have one.
inline int FirstCandidateWith(const Recording& recording, Verdict verdict) {
  const auto& candidates = recording.candidates();
  const auto found =
      std::find_if(candidates.begin(), candidates.end(),
                   [&](const LoopCandidate& candidate) { return candidate.verdict == verdict; });
  EXPECT_NE(found, candidates.end()) << "no candidate is as the test needs it";
  return static_cast<int>(found - candidates.begin());
}

}  // namespace loopscope
