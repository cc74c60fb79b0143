// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "core/graph/graph_state.h"
#include "core/graph/loop_candidate.h"
#include "core/graph/loop_consistency.h"
#include "core/graph/pose_graph_options.h"

namespace loopscope {

/// Judges loops that were found by what others say of the drift between the same places.
class LoopJudge {
 public:
  LoopJudge(const LoopConsistencyOptions& consistency, const OutlierOptions& outliers)
      : consistency_(consistency), outliers_(outliers) {}

  /// Those of the accepted `candidates` with fewer than min_num_supporters.
  std::vector<const LoopCandidate*> LoneLoops(const GraphState& graph,
                                              const std::vector<LoopCandidate>& candidates) const;

  /// Turns the verdict on accepted candidates that too few others agree with, of those found with
  /// them and of those believed before. With those of a last look the optimized map has to agree
  /// instead: what it was not told until then is not worth a wall that is somewhat like another.
  void RejectInconsistent(const GraphState& graph, std::vector<LoopCandidate>* candidates) const;

  /// Takes an accepted candidate for one that others are judged by.
  void Believe(const GraphState& graph, const LoopCandidate& loop);

  std::size_t num_believed() const { return believed_.size(); }

 private:
  int NumSupportersOf(const GraphState& graph, const LoopCandidate& loop,
                      const LoopDrifts& found) const;
  bool IsConsistent(const LoopCandidate& loop) const;

  LoopConsistencyOptions consistency_;
  OutlierOptions outliers_;
  LoopDrifts believed_;
};

}  // namespace loopscope
