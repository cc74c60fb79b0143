// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <utility>

#include "core/graph/loop_gate.h"
#include "core/graph/loop_search.h"
#include "core/graph/travel_graph.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

/// What a search of the node in the submap uses; nothing if there can be none.
std::optional<RangeData> SearchableScan(const Recording& recording, SubmapId submap, NodeId node) {
  const bool finished = recording.submap(submap).finished_step >= 0;
  if (!finished || recording.node(node).LiesIn(submap)) return std::nullopt;
  RangeData scan = LoopScanOfNode(recording, node);
  if (scan.returns.empty()) return std::nullopt;
  return scan;
}

/// The pair as the mapper considered it, if it did so and searched it.
std::optional<LoopCandidate> SearchedCandidate(const Recording& recording, SubmapId submap,
                                               NodeId node) {
  const std::optional<int> index = recording.FindCandidate(submap, node);
  if (!index || recording.candidates()[*index].verdict == Verdict::kNotSampled) return std::nullopt;
  return recording.candidates()[*index];
}

/// The pair if it was searched after the final optimization, whose poses no state has.
std::optional<LoopCandidate> LastLook(const Recording& recording, SubmapId submap, NodeId node) {
  const std::optional<LoopCandidate> searched = SearchedCandidate(recording, submap, node);
  return searched && searched->last_look ? searched : std::nullopt;
}

/// The question without the answer.
LoopCandidate AsAsked(const LoopCandidate& searched) {
  LoopCandidate asked;
  asked.submap = searched.submap;
  asked.node = searched.node;
  asked.considered_step = searched.considered_step;
  asked.last_look = searched.last_look;
  asked.submap_from_node_guess = searched.submap_from_node_guess;
  asked.linear_search_window = searched.linear_search_window;
  asked.angular_search_window = searched.angular_search_window;
  asked.min_score = searched.min_score;
  return asked;
}

/// When a pair came up last: at the later of the node's insertion and the submap's end, unless it
/// got a second look.
int ConsideredStep(const Recording& recording, SubmapId submap, NodeId node) {
  if (const auto index = recording.FindCandidate(submap, node)) {
    return recording.candidates()[*index].considered_step;
  }
  return std::max(recording.submap(submap).finished_step, recording.node(node).step);
}

Eigen::AlignedBox2d NodeBox(const Recording& recording, SubmapId submap) {
  const Submap& record = recording.submap(submap);
  Eigen::AlignedBox2d box;
  for (int i = record.first_node.index; i < record.first_node.index + record.num_nodes; ++i) {
    box.extend(SubmapFromNode(recording, submap, NodeId{i}).translation);
  }
  return box;
}

double MinLoopScoreOf(const Recording& recording, SubmapId submap) {
  const Submap& record = recording.submap(submap);
  std::vector<PointCloud> points;
  std::vector<PlacedScan> own_nodes;
  points.reserve(record.num_nodes);
  for (int i = record.first_node.index; i < record.first_node.index + record.num_nodes; ++i) {
    points.push_back(LoopScanOfNode(recording, NodeId{i}).returns);
    own_nodes.push_back({&points.back(), SubmapFromNode(recording, submap, NodeId{i})});
  }
  return MinLoopScore(own_nodes, GridOfSubmap(recording, submap),
                      recording.options().pose_graph.constraint_builder);
}

/// What the gaps between nodes [m] count, `count(gap, node after it)`, added up until each node.
template <typename Count>
std::vector<double> SumOfGaps(const std::vector<Node>& nodes, const Count& count) {
  std::vector<double> sums;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    sums.push_back(i == 0 ? 0.0
                          : sums.back() + count((nodes[i].local_from_base.translation -
                                                 nodes[i - 1].local_from_base.translation)
                                                    .norm(),
                                                nodes[i]));
  }
  return sums;
}

/// What the mapper knew of the ways between submaps in `state`.
TravelGraph TravelGraphOf(const Recording& recording, const MapState& state) {
  TravelGraph graph;
  const std::vector<double> ways = SumOfGaps(recording.nodes(), [&](double gap, const Node& node) {
    const std::optional<MatchStart> start = recording.step(node.step).match_start;
    return CountedWay(gap, start && MatchedNowhere(*start),
                      recording.options().pose_graph.constraint_builder);
  });
  double way_before = 0.0;
  for (int i = 0; i < state.num_submaps; ++i) {
    const double way = ways[recording.submaps()[i].first_node.index];
    graph.AddSubmap(way - std::exchange(way_before, way));
  }
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.verdict != Verdict::kAccepted) continue;
    graph.AddLoop(candidate.submap, recording.node(candidate.node).first_submap);
  }
  return graph;
}

MapState StateWhenConsidered(const Recording& recording, SubmapId submap, NodeId node) {
  return StateBeforeOptimization(recording, ConsideredStep(recording, submap, node));
}

Pose2 Guess(const MapState& state, SubmapId submap, NodeId node) {
  return state.global_from_submap[submap.index].Inverse() * state.global_from_node[node.index];
}

/// [m] that the robot went between submap and node, in the state when they came up. Added up from
/// the one that came last, as the mapper did: the order of a sum shows in its last bit.
double WayBetween(const Recording& recording, const MapState& state, SubmapId submap, NodeId node) {
  const Node& record = recording.node(node);
  const bool node_came_last =
      record.step > recording.submap(submap).finished_step && record.step == state.step;
  const SubmapId from = node_came_last ? record.first_submap : submap;
  const SubmapId to = node_came_last ? submap : record.first_submap;
  return TravelGraphOf(recording, state).WaysFrom(from)[to.index];
}

/// Of their windows that searches took in `state`.
DriftShare DriftShareIn(const Recording& recording, const MapState& state) {
  if (state.num_optimizations == 0) return DriftShare{};
  return recording.optimizations()[state.num_optimizations - 1].drift_share;
}

LoopGate GateIn(const MapState& state, const Recording& recording, SubmapId submap, NodeId node) {
  return EvaluateLoopGate(Guess(state, submap, node), NodeBox(recording, submap),
                          WayBetween(recording, state, submap, node),
                          recording.options().pose_graph.constraint_builder);
}

/// Without its trace, which may take long and be large, unless that is asked for.
std::optional<SearchReplay> Replay(const Recording& recording, SubmapId submap, NodeId node,
                                   std::optional<double> min_score, bool with_trace) {
  std::optional<RangeData> scan = SearchableScan(recording, submap, node);
  if (!scan) return std::nullopt;
  const std::optional<LoopCandidate> searched = SearchedCandidate(recording, submap, node);
  SearchReplay replay{searched.value_or(LoopCandidate{}),
                      searched.has_value(),
                      GridOfSubmap(recording, submap),
                      std::move(*scan),
                      LoopCandidate{},
                      std::nullopt,
                      SearchTrace{}};
  if (!searched) replay.candidate = ConsiderPair(recording, submap, node);
  if (min_score) replay.candidate.min_score = *min_score;
  const ConstraintBuilderOptions& options = recording.options().pose_graph.constraint_builder;
  const BranchAndBoundMatcher matcher(replay.grid,
                                      options.fast_correlative_scan_matcher.branch_and_bound_depth);
  const auto [result, rival] =
      SearchLoop(replay.candidate, replay.scan, replay.grid, matcher, options);
  replay.result = result;
  if (rival) replay.submap_from_rival = rival->submap_from_scan;
  if (with_trace) {
    matcher.Search(replay.scan.returns, result.submap_from_node_guess, result.linear_search_window,
                   result.angular_search_window, result.min_score, &replay.trace);
  }
  return replay;
}

}  // namespace

std::vector<double> NodeWays(const Recording& recording) {
  return SumOfGaps(recording.nodes(), [](double gap, const Node&) { return gap; });
}

std::optional<SearchReplay> ReplaySearch(const Recording& recording, SubmapId submap, NodeId node,
                                         std::optional<double> min_score) {
  return Replay(recording, submap, node, min_score, true);
}

std::optional<LoopCandidate> SearchPair(const Recording& recording, SubmapId submap, NodeId node,
                                        std::optional<double> min_score) {
  const std::optional<SearchReplay> replay = Replay(recording, submap, node, min_score, false);
  return replay ? std::optional(replay->result) : std::nullopt;
}

std::optional<LoopCandidate> SearchWholeSubmap(const Recording& recording, SubmapId submap,
                                               NodeId node, std::optional<double> min_score) {
  const std::optional<RangeData> scan = SearchableScan(recording, submap, node);
  if (!scan) return std::nullopt;
  const ConstraintBuilderOptions& options = recording.options().pose_graph.constraint_builder;
  LoopCandidate candidate = ConsiderPair(recording, submap, node);
  candidate.whole_submap = true;
  candidate.min_score = min_score.value_or(options.global_localization_min_score);
  const ProbabilityGrid grid = GridOfSubmap(recording, submap);
  const BranchAndBoundMatcher matcher(grid,
                                      options.fast_correlative_scan_matcher.branch_and_bound_depth);
  return SearchLoop(candidate, *scan, grid, matcher, options).candidate;
}

LoopGate GateOfPair(const Recording& recording, SubmapId submap, NodeId node) {
  LoopGate gate = GateIn(StateWhenConsidered(recording, submap, node), recording, submap, node);
  if (const auto look = LastLook(recording, submap, node)) {
    gate.distance =
        NodeBox(recording, submap).exteriorDistance(look->submap_from_node_guess.translation);
    gate.linear_window = look->linear_search_window;
    gate.angular_window = look->angular_search_window;
    gate.way = 0.0;  // the final poses are not expected to drift
    gate.is_near = true;
  }
  return gate;
}

Pose2 GuessOfPair(const Recording& recording, SubmapId submap, NodeId node) {
  if (const auto look = LastLook(recording, submap, node)) return look->submap_from_node_guess;
  return Rounded(Guess(StateWhenConsidered(recording, submap, node), submap, node));
}

LoopCandidate ConsiderPair(const Recording& recording, SubmapId submap, NodeId node) {
  if (const auto look = LastLook(recording, submap, node)) return AsAsked(*look);
  const MapState state = StateWhenConsidered(recording, submap, node);
  const LoopCandidate candidate =
      AtGate(GateIn(state, recording, submap, node), submap, node, state.step,
             Guess(state, submap, node), MinLoopScoreOf(recording, submap));
  return Rounded(WithDriftShare(candidate, DriftShareIn(recording, state)));
}

}  // namespace loopscope
