// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/derive.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "core/graph/loop_search.h"
#include "core/grid/ray_cast.h"
#include "core/local/scan_preparation.h"
#include "core/matching/match_score.h"
#include "core/matching/wide_walls.h"

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

/// The cells that a node hit and missed, on the lattice of the local frame.
ScanCells LocalCellsOfNode(const Recording& recording, NodeId node) {
  const SubmapsOptions& options = LocalOptions(recording).submaps;
  const Node& record = recording.node(node);
  return CastRays(Transform(record.local_from_base, RangeDataOfStep(recording, record.step)),
                  options.grid_resolution, options.range_data_inserter.max_wall_gap);
}

}  // namespace

RangeData RangeDataOfStep(const Recording& recording, int step) {
  return PrepareRangeData(recording.log(), step, LocalOptions(recording));
}

RangeData RangeDataInMap(const Recording& recording, const MapState& state, NodeId node) {
  return Transform(state.global_from_node[node.index],
                   RangeDataOfStep(recording, recording.node(node).step));
}

RangeData LoopScanOfNode(const Recording& recording, NodeId node) {
  return LoopScan(RangeDataOfStep(recording, recording.node(node).step), LocalOptions(recording));
}

Pose2 SubmapFromNode(const Recording& recording, SubmapId submap, NodeId node) {
  return recording.submap(submap).local_from_submap.Inverse() *
         recording.node(node).local_from_base;
}

ScanCells CellsOfNode(const Recording& recording, SubmapId submap, NodeId node) {
  return ToSubmapLattice(LocalCellsOfNode(recording, node),
                         recording.submap(submap).local_from_submap,
                         LocalOptions(recording).submaps.grid_resolution);
}

ProbabilityGrid GridOfSubmap(const Recording& recording, SubmapId submap, int num_nodes) {
  if (num_nodes < 0) num_nodes = recording.submap(submap).num_nodes;
  std::vector<ProbabilityGrid> grids(
      1, ProbabilityGrid(LocalOptions(recording).submaps.grid_resolution));
  GrowGrids(recording, submap, {0}, {num_nodes}, &grids);
  return std::move(grids.front());
}

void GrowGrids(const Recording& recording, SubmapId first, const std::vector<int>& begins,
               const std::vector<int>& ends, std::vector<ProbabilityGrid>* grids) {
  const SubmapsOptions& options = LocalOptions(recording).submaps;
  const ScanInserter inserter(options.range_data_inserter);
  const int count = static_cast<int>(grids->size());
  std::vector<int> begin_nodes;
  std::vector<int> end_nodes;
  for (int i = 0; i < count; ++i) {
    const Submap& submap = recording.submap(SubmapId{first.index + i});
    assert(ends[i] <= submap.num_nodes);
    begin_nodes.push_back(submap.first_node.index + begins[i]);
    end_nodes.push_back(submap.first_node.index + ends[i]);
  }
  const NodeId end{*std::max_element(end_nodes.begin(), end_nodes.end())};
  for (NodeId node{*std::min_element(begin_nodes.begin(), begin_nodes.end())}; node < end;
       ++node.index) {
    std::optional<ScanCells> cells_in_local;
    const Node& record = recording.node(node);
    for (int k = 0; k < record.num_submaps; ++k) {
      const SubmapId submap{record.first_submap.index + k};
      const int i = submap.index - first.index;
      if (i < 0 || i >= count || node.index < begin_nodes[i] || node.index >= end_nodes[i]) {
        continue;
      }
      if (!cells_in_local) cells_in_local = LocalCellsOfNode(recording, node);
      inserter.Insert(
          *cells_in_local, &(*grids)[i],
          OriginOfLattice(recording.submap(submap).local_from_submap, options.grid_resolution));
    }
  }
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
  std::optional<PointCloud> points =
      PointsToMatch(RangeDataOfStep(recording, step), LocalOptions(recording));
  if (!points) return std::nullopt;
  const Step& record = recording.step(step);
  const Pose2 submap_from_local = recording.submap(*submap).local_from_submap.Inverse();
  ProbabilityGrid grid =
      GridOfSubmap(recording, *submap, NumNodesOfSubmapAfterStep(recording, *submap, step - 1));
  if (record.wide_walls) grid = WithWideWalls(grid, LocalOptions(recording).share_beside_walls);
  MatchReplay replay{*submap,
                     std::move(grid),
                     record.wide_walls,
                     std::move(*points),
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

}  // namespace loopscope
