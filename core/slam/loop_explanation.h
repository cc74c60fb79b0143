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
  bool closed = false;            ///< and in force at the end
  std::string answer;             ///< one sentence
  std::vector<LoopCheck> checks;  ///< in the order in which they are made; none behind a failed one
  /// If the pair was not searched, or the search found nothing: the best place in its window, found
  /// now, however little it scores. The mapper's search ends as soon as nothing can win.
  std::optional<LoopCandidate> best_in_window;
};

/// Explains the pair as it stood at the end of the recording. `submap` and `node` must exist.
LoopExplanation ExplainLoop(const Recording& recording, SubmapId submap, NodeId node);

/// The best place in the whole submap of a pair that has a `best_in_window`: one sentence. It tells
/// whether the window was too small, and takes up to a second.
std::string ExplainWholeSubmap(const Recording& recording, const LoopCandidate& best_in_window);

/// The error of an accepted loop (eq. 5) in the poses of `state`: [m, m, rad].
Eigen::Vector3d LoopResidual(const MapState& state, const LoopCandidate& accepted);

/// "closed", "inconsistent", "ambiguous", "from behind", "below score", "not sampled", "too far".
std::string ToString(Verdict verdict);

/// Why a candidate got its verdict, in a few words without numbers.
std::string ReasonOf(const LoopCandidate& candidate);

/// How many of `candidates` have each of kRecordedVerdicts, such as "12 closed".
std::vector<std::string> VerdictSummary(const std::vector<LoopCandidate>& candidates);

}  // namespace loopscope
