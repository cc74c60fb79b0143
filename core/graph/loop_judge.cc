// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_judge.h"

#include "core/graph/last_look.h"
#include "core/graph/outliers.h"

namespace loopscope {
namespace {

LoopDrift DriftOf(const GraphState& graph, const LoopCandidate& loop) {
  const GraphNode& node = graph.node(loop.node);
  const GraphSubmap& submap = graph.submap(loop.submap);
  return {loop.node, node.local_from_node,
          submap.local_from_submap * loop.submap_from_node * node.local_from_node.Inverse(),
          graph.node_ways[loop.node.index], graph.node_ways[submap.first_node.index]};
}

/// Of those accepted so far.
LoopDrifts DriftsOf(const GraphState& graph, const std::vector<LoopCandidate>& candidates) {
  LoopDrifts drifts;
  for (const LoopCandidate& candidate : candidates) {
    if (candidate.verdict == Verdict::kAccepted) drifts.Add(DriftOf(graph, candidate));
  }
  return drifts;
}

}  // namespace

std::vector<const LoopCandidate*> LoopJudge::LoneLoops(
    const GraphState& graph, const std::vector<LoopCandidate>& candidates) const {
  const LoopDrifts drifts = DriftsOf(graph, candidates);
  std::vector<const LoopCandidate*> lone_loops;
  for (const LoopCandidate& candidate : candidates) {
    if (candidate.verdict == Verdict::kAccepted &&
        NumSupportersOf(graph, candidate, drifts) < consistency_.min_num_supporters) {
      lone_loops.push_back(&candidate);
    }
  }
  return lone_loops;
}

void LoopJudge::RejectInconsistent(const GraphState& graph,
                                   std::vector<LoopCandidate>* candidates) const {
  const LoopDrifts drifts = DriftsOf(graph, *candidates);
  for (LoopCandidate& candidate : *candidates) {
    if (candidate.verdict != Verdict::kAccepted) continue;
    candidate.num_supporters = NumSupportersOf(graph, candidate, drifts);
    if (!IsConsistent(candidate)) candidate.verdict = Verdict::kInconsistent;
  }
}

void LoopJudge::Believe(const GraphState& graph, const LoopCandidate& loop) {
  believed_.Add(DriftOf(graph, loop));
}

int LoopJudge::NumSupportersOf(const GraphState& graph, const LoopCandidate& loop,
                               const LoopDrifts& found) const {
  const LoopDrift drift = DriftOf(graph, loop);
  std::vector<LoopDrift> near;
  believed_.AddNear(drift, consistency_.max_way, &near);
  found.AddNear(drift, consistency_.max_way, &near);
  return NumSupporters(drift, near, consistency_);
}

bool LoopJudge::IsConsistent(const LoopCandidate& loop) const {
  if (loop.last_look) return !IsOutlier(ResidualAtGuess(loop), outliers_);
  return loop.num_supporters >= MinNumSupporters(loop, consistency_);
}

}  // namespace loopscope
