// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/evaluation/loop_closures.h"
#include "core/evaluation/revisits.h"

namespace loopscope {

/// A loop that the reference says is false, and what its scan says. If that fits where the loop has
/// it and not where the reference does, the match is right: it is the submap that is bent, or a
/// reference that another mapper made is wrong itself.
struct FalseLoop {
  JudgedLoop loop;
  /// The best scores of the scan in the submap within half of the tolerance (at most 1 m and 10
  /// deg) of where the loop has the node, and of where the reference has it; in [0.1, 0.9].
  double score = 0.0;
  double score_in_reference = 0.0;

  bool FitsBetterInReference() const { return score_in_reference >= score; }
};

/// The loops of a run, against the true way.
struct LoopEvaluation {
  LoopCounts counts;
  std::vector<FalseLoop> false_loops;  ///< in force, and out of tolerance
  int num_revisits = 0;                ///< 0 without a reference, as the next two
  int num_never_accepted = 0;          ///< revisits without any loop but false ones
  std::vector<Revisit> missed;         ///< likewise, as far as they are in force
};

/// `reference` is as JudgeLoops takes it.
LoopEvaluation EvaluateLoops(const Recording& recording, const MapState& state,
                             const ReferencePoses& reference, const LoopTolerance& tolerance);

}  // namespace loopscope
