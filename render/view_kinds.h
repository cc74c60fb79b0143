// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <string>

namespace loopscope {

enum class ViewKind {
  kMap,     ///< all submaps at their optimized poses, and the way of the robot
  kSubmap,  ///< one probability grid, its scans and its frame
  kUpdate,  ///< what one scan hit and missed, and the odds before and after
  kMatch,   ///< one scan where it was predicted and where it was matched
  kSearch,  ///< one loop search: where it looked, what it pruned, and what it found
  kGraph,   ///< nodes, submaps, the constraints between them and their residuals
  kTime,    ///< the same seen from the side, with time upwards over the map
  kChart,   ///< numbers of the run: scores, residuals, costs
};

/// What can be drawn in a panel, from the bottom to the top.
enum class LayerKind {
  kGrid,
  kMisses,
  kHits,
  kOdds,
  kTree,
  kRays,
  kWindow,
  kIntra,
  kTrajectory,
  kNodes,
  kRefused,
  kInter,
  kResiduals,
  kScan,
  kCovariances,
  kFrames,
  kRobot,
  kSelection,
  kLabels,
};

/// "map", "submap", "update", "match", "search", "graph", "time" or "chart". Throws
/// std::invalid_argument naming these for anything else.
ViewKind ViewKindFromName(const std::string& name);
std::string ToString(ViewKind kind);

/// "grid", "misses", "hits", ... Throws std::invalid_argument naming all for anything else.
LayerKind LayerKindFromName(const std::string& name);
std::string ToString(LayerKind kind);

/// The layers that a view has, and those of them that it draws if nothing else is asked for.
const std::set<LayerKind>& LayersOf(ViewKind kind);
const std::set<LayerKind>& DefaultLayersOf(ViewKind kind);

}  // namespace loopscope
