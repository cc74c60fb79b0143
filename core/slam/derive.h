// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/graph/constraint.h"
#include "core/graph/loop_gate.h"
#include "core/grid/probability_grid.h"
#include "core/matching/search_trace.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

// What a recording does not hold because it follows from it. Every function here calls the very
// functions that the mapper called, so its answer is what the mapper saw, bit for bit.

/// The readings of the scan of `step` that were used, in the frame of the robot.
RangeData RangeDataOfStep(const Recording& recording, int step);

/// Those of the scan of a node, in the global frame of `state`.
RangeData RangeDataInMap(const Recording& recording, const MapState& state, NodeId node);

/// Pose of a node in a submap as local SLAM had it.
Pose2 SubmapFromNode(const Recording& recording, SubmapId submap, NodeId node);

/// What loop searches use of the scan of a node, in its frame.
RangeData LoopScanOfNode(const Recording& recording, NodeId node);

/// The cells that a node hit and missed, on the lattice of `submap`.
ScanCells CellsOfNode(const Recording& recording, SubmapId submap, NodeId node);

/// The grid of a submap after its first `num_nodes` nodes; all by default.
ProbabilityGrid GridOfSubmap(const Recording& recording, SubmapId submap, int num_nodes = -1);

/// Inserts nodes into the grids of submaps that follow each other from `first` on: of the submap
/// first + i those from number begins[i] on, until it has the first ends[i] of its nodes. Takes
/// little more than half the time of doing so one by one, for most scans went into two.
void GrowGrids(const Recording& recording, SubmapId first, const std::vector<int>& begins,
               const std::vector<int>& ends, std::vector<ProbabilityGrid>* grids);

/// Number of nodes of a submap that had been inserted after `step`.
int NumNodesOfSubmapAfterStep(const Recording& recording, SubmapId submap, int step);

/// INTRA_SUBMAP and INTER_SUBMAP constraints in force in `state`, in this order.
std::vector<Constraint> ConstraintsOf(const Recording& recording, const MapState& state);

/// How one scan was matched (local SLAM), in the frame of the submap it was matched against.
struct MatchReplay {
  SubmapId submap;
  ProbabilityGrid
      grid;  ///< of the submap before the scan was inserted; if `wide_walls`, with these
  bool wide_walls = false;  ///< see WithWideWalls
  PointCloud points;        ///< in the frame of the robot, as given to the matchers
  Pose2 submap_from_base_prior;
  std::optional<Pose2> submap_from_base_correlative;
  Pose2 submap_from_base;
  double prior_score = 0.0;  ///< mean probability at the points
  double score = 0.0;        ///< likewise, after the match
};

/// Nothing if the scan was not matched: it was the first, or had too few returns.
std::optional<MatchReplay> ReplayMatch(const Recording& recording, int step);

/// [m] that the robot had gone at each node, as local SLAM has it.
std::vector<double> NodeWays(const Recording& recording);

/// The gate that a pair had to go through when it came up last: at the later of the node's
/// insertion and the submap's end, which must have finished, or when it got a second look. After a
/// last look: what that went by.
LoopGate GateOfPair(const Recording& recording, SubmapId submap, NodeId node);

/// submap_from_node of a pair by the poses when it came up last.
Pose2 GuessOfPair(const Recording& recording, SubmapId submap, NodeId node);

/// The pair when it came up last, as the mapper would have asked for it to be searched; the verdict
/// is kTooFar, or kNotSampled if it went through the gate. Pairs that were searched to check a lone
/// loop nearby were so around where that has them. The submap must have finished.
LoopCandidate ConsiderPair(const Recording& recording, SubmapId submap, NodeId node);

/// A loop search made once more, exactly as the mapper did or would have.
struct SearchReplay {
  LoopCandidate
      candidate;  ///< as recorded; if the pair was never searched, from its poses when it came up
  bool recorded = false;  ///< whether the mapper itself searched the pair
  ProbabilityGrid grid;   ///< of the finished submap
  RangeData scan;         ///< in the frame of the node
  LoopCandidate result;   ///< of the replay; equals `candidate` if recorded and not overridden
  std::optional<Pose2> submap_from_rival;  ///< where result.rival_score is, if there is one
  SearchTrace trace;
};

/// Replays the search of `node` in the finished `submap`. Nothing if the submap never was finished,
/// or the node lies in it or has no points to search with. `min_score` overrides that of the
/// options.
std::optional<SearchReplay> ReplaySearch(const Recording& recording, SubmapId submap, NodeId node,
                                         std::optional<double> min_score = std::nullopt);

/// What ReplaySearch has for its result.
std::optional<LoopCandidate> SearchPair(const Recording& recording, SubmapId submap, NodeId node,
                                        std::optional<double> min_score = std::nullopt);

/// What a search of `node` everywhere in the finished `submap`, at every angle, finds, for
/// `min_score` or else global_localization_min_score. The mapper makes none; it tells what a window
/// missed. Nothing where ReplaySearch gives nothing.
std::optional<LoopCandidate> SearchWholeSubmap(const Recording& recording, SubmapId submap,
                                               NodeId node,
                                               std::optional<double> min_score = std::nullopt);

}  // namespace loopscope
