// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/slam/derive.h"

namespace loopscope {

/// One thing that a pair must satisfy to become a loop.
struct LoopCheck {
  std::string what;      ///< e.g. "score"
  std::string value;     ///< with unit
  std::string expected;  ///< e.g. "more than 0.51"; empty if there is nothing to fail
  bool passed = true;
};

/// Why a pair of node and submap became a loop, or did not.
struct LoopExplanation {
  bool closed = false;
  std::string answer;             ///< one sentence
  std::vector<LoopCheck> checks;  ///< in the order in which they are made; none behind a failed one
};

/// Explains the pair as it stood at the end of the recording. A pair that was not searched is
/// searched now, to tell how well it would have matched. `submap` and `node` must exist.
LoopExplanation ExplainLoop(const Recording& recording, SubmapId submap, NodeId node);

/// The error of an accepted loop (eq. 5) in the poses of `state`: [m, m, rad].
Eigen::Vector3d LoopResidual(const MapState& state, const LoopCandidate& accepted);

/// "closed", "inconsistent", "ambiguous", "from behind", "below score", "not sampled", "too far".
std::string ToString(Verdict verdict);

/// Why a candidate got its verdict, in a few words without numbers.
std::string ReasonOf(Verdict verdict);

/// How many of `candidates` have each of kRecordedVerdicts, such as "12 closed".
std::vector<std::string> VerdictSummary(const std::vector<LoopCandidate>& candidates);

}  // namespace loopscope
