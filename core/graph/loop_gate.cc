// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_gate.h"

#include <algorithm>
#include <cmath>

#include "core/matching/match_score.h"

namespace loopscope {

double CountedWay(double gap, bool matched_nowhere, const ConstraintBuilderOptions& options) {
  constexpr double kMaxGap = 1.0;  // [m]
  return gap * (1.0 + options.search_window_growth_per_gap * std::min(gap, kMaxGap)) +
         (matched_nowhere ? options.unmatched_node_way : 0.0);
}

LoopGate EvaluateLoopGate(const Pose2& submap_from_node_guess, const Eigen::AlignedBox2d& node_box,
                          double way, const ConstraintBuilderOptions& options) {
  const BranchAndBoundOptions& least = options.fast_correlative_scan_matcher;
  LoopGate gate;
  gate.way = way;
  gate.distance = node_box.exteriorDistance(submap_from_node_guess.translation);
  gate.linear_window =
      std::max(least.linear_search_window,
               std::min(least.linear_search_window + options.linear_search_window_per_meter * way,
                        options.max_linear_search_window));
  gate.angular_window =
      std::min(least.angular_search_window + options.angular_search_window_per_meter * way, M_PI);
  const double growth = gate.linear_window - least.linear_search_window;
  gate.is_near = gate.distance <= options.max_constraint_distance + growth;
  return gate;
}

LoopCandidate AtGate(const LoopGate& gate, SubmapId submap, NodeId node, int step,
                     const Pose2& submap_from_node_guess, double min_score) {
  LoopCandidate candidate;
  candidate.submap = submap;
  candidate.node = node;
  candidate.considered_step = step;
  candidate.submap_from_node_guess = submap_from_node_guess;
  candidate.linear_search_window = gate.linear_window;
  candidate.angular_search_window = gate.angular_window;
  candidate.min_score = min_score;
  candidate.verdict = gate.is_near ? Verdict::kNotSampled : Verdict::kTooFar;
  return candidate;
}

double MaxLinearWindow(const ConstraintBuilderOptions& options) {
  return std::max(options.fast_correlative_scan_matcher.linear_search_window,
                  options.max_linear_search_window);
}

double MaxGateDistance(const ConstraintBuilderOptions& options) {
  return options.max_constraint_distance + MaxLinearWindow(options) -
         options.fast_correlative_scan_matcher.linear_search_window;
}

double SamplingShare(double linear_window, double gap, const ConstraintBuilderOptions& options) {
  constexpr double kLeastOfGap = 0.25;
  const double full_window = options.full_sampling_search_window;
  const double full_gap = options.full_sampling_gap;
  double share = 1.0;
  if (full_window > 0.0 && linear_window > full_window) share *= full_window / linear_window;
  if (gap < full_gap) share *= std::max(gap / full_gap, kLeastOfGap);
  return share;
}

double MinLoopScore(const std::vector<PlacedScan>& own_nodes, const ProbabilityGrid& grid,
                    const ConstraintBuilderOptions& options) {
  double sum = 0.0;
  int num_scored = 0;
  for (const PlacedScan& node : own_nodes) {
    if (node.points_in_node->empty()) continue;
    sum += MeanProbability(*node.points_in_node, node.submap_from_node, grid);
    ++num_scored;
  }
  const double own_score = num_scored > 0 ? sum / num_scored : 0.0;
  return std::max(options.min_score, options.min_relative_score * own_score);
}

}  // namespace loopscope
