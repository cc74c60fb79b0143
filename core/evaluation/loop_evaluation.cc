// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/loop_evaluation.h"

#include <algorithm>
#include <map>

#include "core/matching/branch_and_bound.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

/// Tells how well scans fit into submaps, near to where they are said to be.
class FitNearby {
 public:
  FitNearby(const Recording& recording, const LoopTolerance& tolerance)
      : recording_(recording),
        window_{std::min(0.5 * tolerance.translation, 1.0),
                std::min(0.5 * tolerance.rotation, DegreesToRadians(10.0))} {}

  /// The best score around `submap_from_node`.
  double ScoreOf(SubmapId submap, NodeId node, const Pose2& submap_from_node) {
    const PointCloud points = LoopScanOfNode(recording_, node).returns;
    if (points.empty()) return kMinProbability;
    return MatcherOf(submap)
        .Search(points, submap_from_node, window_.translation, window_.rotation, 0.0)
        .best_found.score;
  }

 private:
  const BranchAndBoundMatcher& MatcherOf(SubmapId submap) {
    const int depth =
        recording_.options()
            .pose_graph.constraint_builder.fast_correlative_scan_matcher.branch_and_bound_depth;
    return matchers_.try_emplace(submap.index, GridOfSubmap(recording_, submap), depth)
        .first->second;
  }

  const Recording& recording_;
  LoopTolerance window_;
  std::map<int, BranchAndBoundMatcher> matchers_;  ///< by submap
};

}  // namespace

LoopEvaluation EvaluateLoops(const Recording& recording, const MapState& state,
                             const ReferencePoses& reference, const LoopTolerance& tolerance) {
  const std::vector<JudgedLoop> loops = JudgeLoops(recording, state, reference);
  LoopEvaluation evaluation;
  evaluation.counts = CountLoops(loops, tolerance);
  FitNearby fit(recording, tolerance);
  std::vector<JudgedLoop> accepted, held;  // without those that are false
  for (const JudgedLoop& loop : loops) {
    const bool is_false = IsWrong(loop, tolerance);
    if (!is_false) accepted.push_back(loop);
    if (!loop.IsInForce()) continue;
    if (!is_false) {
      held.push_back(loop);
      continue;
    }
    const Pose2 submap_from_node_in_reference = loop.submap_from_node * loop.error->Inverse();
    evaluation.false_loops.push_back(
        {loop, fit.ScoreOf(loop.submap, loop.node, loop.submap_from_node),
         fit.ScoreOf(loop.submap, loop.node, submap_from_node_in_reference)});
  }
  const std::vector<Revisit> revisits = RevisitsOf(recording, reference);
  evaluation.num_revisits = static_cast<int>(revisits.size());
  evaluation.num_never_accepted =
      static_cast<int>(RevisitsWithout(recording, accepted, revisits).size());
  evaluation.missed = RevisitsWithout(recording, held, revisits);
  return evaluation;
}

}  // namespace loopscope
