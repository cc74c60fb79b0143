// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/derive.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/graph/loop_gate.h"
#include "core/graph/loop_search.h"
#include "core/graph/travel_graph.h"
#include "core/grid/ray_cast.h"
#include "core/local/scan_preparation.h"
#include "core/matching/match_score.h"

namespace loopscope {
namespace {

const LocalSlamOptions& LocalOptions(const Recording& recording) {
  return recording.options().trajectory_builder_2d;
}

/// The submap that the scan of `step` was matched against: the older of those active then.
std::optional<SubmapId> MatchingSubmapOfStep(const Recording& recording, int step) {
  for (int i = 0; i < static_cast<int>(recording.submaps().size()); ++i) {
    const Submap& submap = recording.submaps()[i];
    const bool begun = recording.node(submap.first_node).step < step;
    const bool active = submap.finished_step < 0 || submap.finished_step >= step;
    if (begun && active) return SubmapId{i};
  }
  return std::nullopt;
}

bool LiesIn(const Submap& submap, NodeId node) {
  return submap.first_node.index <= node.index &&
         node.index < submap.first_node.index + submap.num_nodes;
}

/// The pair as the mapper considered it, if it did so and searched it.
std::optional<LoopCandidate> SearchedCandidate(const Recording& recording, SubmapId submap,
                                               NodeId node) {
  const auto& candidates = recording.candidates();
  const auto found =
      std::find_if(candidates.begin(), candidates.end(), [&](const LoopCandidate& candidate) {
        return candidate.submap == submap && candidate.node == node &&
               candidate.verdict != Verdict::kNotSampled;
      });
  if (found == candidates.end()) return std::nullopt;
  return *found;
}

/// When a pair came up: at the later of the node's insertion and the submap's end.
int ConsideredStep(const Recording& recording, SubmapId submap, NodeId node) {
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
    points.push_back(LoopPointsOfNode(recording, NodeId{i}));
    own_nodes.push_back({&points.back(), SubmapFromNode(recording, submap, NodeId{i})});
  }
  return MinLoopScore(own_nodes, GridOfSubmap(recording, submap),
                      recording.options().pose_graph.constraint_builder);
}

/// [m] that the robot had gone at each node.
std::vector<double> NodeWays(const Recording& recording) {
  std::vector<double> ways;
  for (std::size_t i = 0; i < recording.nodes().size(); ++i) {
    ways.push_back(i == 0 ? 0.0
                          : ways.back() + (recording.nodes()[i].local_from_base.translation -
                                           recording.nodes()[i - 1].local_from_base.translation)
                                              .norm());
  }
  return ways;
}

/// What the mapper knew of the ways between submaps in `state`.
TravelGraph TravelGraphOf(const Recording& recording, const MapState& state) {
  TravelGraph graph;
  const std::vector<double> ways = NodeWays(recording);
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

}  // namespace

RangeData RangeDataOfStep(const Recording& recording, int step) {
  return PrepareRangeData(recording.log(), step, LocalOptions(recording));
}

PointCloud LoopPointsOfNode(const Recording& recording, NodeId node) {
  return AdaptiveVoxelFilter(RangeDataOfStep(recording, recording.node(node).step).returns,
                             LocalOptions(recording).loop_closure_adaptive_voxel_filter);
}

Pose2 SubmapFromNode(const Recording& recording, SubmapId submap, NodeId node) {
  return recording.submap(submap).local_from_submap.Inverse() *
         recording.node(node).local_from_base;
}

ScanCells CellsOfNode(const Recording& recording, SubmapId submap, NodeId node) {
  const double resolution = LocalOptions(recording).submaps.grid_resolution;
  const RangeData range_data_in_local = Transform(
      recording.node(node).local_from_base, RangeDataOfStep(recording, recording.node(node).step));
  return ToSubmapLattice(CastRays(range_data_in_local, resolution),
                         recording.submap(submap).local_from_submap, resolution);
}

ProbabilityGrid GridOfSubmap(const Recording& recording, SubmapId submap, int num_nodes) {
  const SubmapsOptions& options = LocalOptions(recording).submaps;
  const Submap& record = recording.submap(submap);
  if (num_nodes < 0) num_nodes = record.num_nodes;
  assert(num_nodes <= record.num_nodes);
  const ScanInserter inserter(options.range_data_inserter);
  ProbabilityGrid grid(options.grid_resolution);
  for (int i = 0; i < num_nodes; ++i) {
    inserter.Insert(CellsOfNode(recording, submap, NodeId{record.first_node.index + i}), &grid);
  }
  return grid;
}

int NumNodesOfSubmapAfterStep(const Recording& recording, SubmapId submap, int step) {
  const Submap& record = recording.submap(submap);
  int num_nodes = 0;
  while (num_nodes < record.num_nodes &&
         recording.nodes()[record.first_node.index + num_nodes].step <= step) {
    ++num_nodes;
  }
  return num_nodes;
}

std::vector<Constraint> ConstraintsOf(const Recording& recording, const MapState& state) {
  const PoseGraphOptions& options = recording.options().pose_graph;
  std::vector<Constraint> constraints;
  for (NodeId node{0}; node.index < state.num_nodes; ++node.index) {
    const Node& record = recording.node(node);
    for (int i = 0; i < record.num_submaps; ++i) {
      const SubmapId submap{record.first_submap.index + i};
      constraints.push_back({submap, node, SubmapFromNode(recording, submap, node),
                             options.matcher_translation_weight, options.matcher_rotation_weight,
                             Constraint::Tag::kIntraSubmap});
    }
  }
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (candidate.verdict == Verdict::kAccepted) {
      constraints.push_back(ToConstraint(candidate, options.constraint_builder));
    }
  }
  return constraints;
}

std::optional<MatchReplay> ReplayMatch(const Recording& recording, int step) {
  const std::optional<SubmapId> submap = MatchingSubmapOfStep(recording, step);
  if (!submap) return std::nullopt;
  PointCloud points = AdaptiveVoxelFilter(RangeDataOfStep(recording, step).returns,
                                          LocalOptions(recording).adaptive_voxel_filter);
  if (points.empty()) return std::nullopt;
  const Step& record = recording.step(step);
  const Pose2 submap_from_local = recording.submap(*submap).local_from_submap.Inverse();
  MatchReplay replay{
      *submap,
      GridOfSubmap(recording, *submap, NumNodesOfSubmapAfterStep(recording, *submap, step - 1)),
      std::move(points),
      submap_from_local * record.local_from_base_prior,
      std::nullopt,
      submap_from_local * record.local_from_base};
  if (record.local_from_base_correlative) {
    replay.submap_from_base_correlative = submap_from_local * *record.local_from_base_correlative;
  }
  replay.prior_score = MeanProbability(replay.points, replay.submap_from_base_prior, replay.grid);
  replay.score = MeanProbability(replay.points, replay.submap_from_base, replay.grid);
  return replay;
}

std::optional<SearchReplay> ReplaySearch(const Recording& recording, SubmapId submap, NodeId node,
                                         std::optional<double> min_score) {
  const Submap& record = recording.submap(submap);
  if (record.finished_step < 0 || LiesIn(record, node)) return std::nullopt;
  const std::optional<LoopCandidate> searched = SearchedCandidate(recording, submap, node);
  SearchReplay replay{
      searched.value_or(LoopCandidate{}), searched.has_value(), GridOfSubmap(recording, submap),
      LoopPointsOfNode(recording, node),  LoopCandidate{},      SearchTrace{}};
  if (!searched) replay.candidate = ConsiderPair(recording, submap, node);
  if (min_score) replay.candidate.min_score = *min_score;
  const ConstraintBuilderOptions& options = recording.options().pose_graph.constraint_builder;
  const BranchAndBoundMatcher matcher(replay.grid,
                                      options.fast_correlative_scan_matcher.branch_and_bound_depth);
  replay.result = SearchLoop(replay.candidate, replay.points, replay.grid, matcher,
                             options.ceres_scan_matcher, &replay.trace);
  return replay;
}

LoopGate GateOfPair(const Recording& recording, SubmapId submap, NodeId node) {
  const MapState state = StateAfterStep(recording, ConsideredStep(recording, submap, node));
  const Pose2 guess =
      state.global_from_submap[submap.index].Inverse() * state.global_from_node[node.index];
  const std::vector<double> ways = TravelGraphOf(recording, state).WaysFrom(submap);
  return EvaluateLoopGate(guess, NodeBox(recording, submap),
                          ways[recording.node(node).first_submap.index],
                          recording.options().pose_graph.constraint_builder);
}

LoopCandidate ConsiderPair(const Recording& recording, SubmapId submap, NodeId node) {
  LoopCandidate candidate;
  candidate.submap = submap;
  candidate.node = node;
  candidate.considered_step = ConsideredStep(recording, submap, node);
  const MapState state = StateAfterStep(recording, candidate.considered_step);
  candidate.submap_from_node_guess =
      state.global_from_submap[submap.index].Inverse() * state.global_from_node[node.index];
  const LoopGate gate = GateOfPair(recording, submap, node);
  candidate.linear_search_window = gate.linear_window;
  candidate.angular_search_window = gate.angular_window;
  candidate.min_score = MinLoopScoreOf(recording, submap);
  candidate.verdict = gate.is_near ? Verdict::kNotSampled : Verdict::kTooFar;
  return candidate;
}

}  // namespace loopscope
