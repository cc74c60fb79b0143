// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/loop_evaluation.h"

#include <algorithm>
#include <map>

#include "core/matching/branch_and_bound.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

/// Half of `tolerance`, but not much where that is much.
LoopTolerance FitWindow(const LoopTolerance& tolerance) {
  return {std::min(0.5 * tolerance.translation, 1.0),
          std::min(0.5 * tolerance.rotation, DegreesToRadians(10.0))};
}

void SetScores(const BranchAndBoundMatcher& matcher, const PointCloud& points,
               const LoopTolerance& window, FalseLoop* false_loop) {
  const auto best_score = [&](const Pose2& submap_from_node) {
    if (points.empty()) return kMinProbability;
    return matcher.Search(points, submap_from_node, window.translation, window.rotation, 0.0)
        .best_found.score;
  };
  const JudgedLoop& loop = false_loop->loop;
  false_loop->score = best_score(loop.submap_from_node);
  false_loop->score_in_reference = best_score(loop.submap_from_node * loop.error->Inverse());
}

/// One submap after the other: a matcher is large.
void SetScores(const Recording& recording, const LoopTolerance& window,
               std::vector<FalseLoop>* false_loops) {
  std::map<SubmapId, std::vector<FalseLoop*>> by_submap;
  for (FalseLoop& loop : *false_loops) by_submap[loop.loop.submap].push_back(&loop);
  const int depth =
      recording.options()
          .pose_graph.constraint_builder.fast_correlative_scan_matcher.branch_and_bound_depth;
  for (const auto& [submap, of_submap] : by_submap) {
    const BranchAndBoundMatcher matcher(GridOfSubmap(recording, submap), depth);
    for (FalseLoop* const loop : of_submap) {
      SetScores(matcher, LoopScanOfNode(recording, loop->loop.node).returns, window, loop);
    }
  }
}

}  // namespace

LoopEvaluation EvaluateLoops(const Recording& recording, const MapState& state,
                             const ReferencePoses& reference, const LoopTolerance& tolerance) {
  const std::vector<JudgedLoop> loops = JudgeLoops(recording, state, reference);
  LoopEvaluation evaluation;
  evaluation.counts = CountLoops(loops, tolerance);
  std::vector<JudgedLoop> accepted, held;  // without those that are false
  for (const JudgedLoop& loop : loops) {
    const bool is_false = IsWrong(loop, tolerance);
    if (is_false && loop.IsInForce()) evaluation.false_loops.push_back({loop, 0.0, 0.0});
    if (!is_false) accepted.push_back(loop);
    if (!is_false && loop.IsInForce()) held.push_back(loop);
  }
  SetScores(recording, FitWindow(tolerance), &evaluation.false_loops);
  const std::vector<Revisit> revisits = RevisitsOf(recording, reference);
  evaluation.num_revisits = static_cast<int>(revisits.size());
  evaluation.num_never_accepted =
      static_cast<int>(RevisitsWithout(recording, accepted, revisits).size());
  evaluation.missed = RevisitsWithout(recording, held, revisits);
  return evaluation;
}

}  // namespace loopscope
