// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/slam/recording.h"
#include "render/palette.h"
#include "render/scene.h"

namespace loopscope {

enum class ViewKind {
  kMap,     ///< all submaps at their optimized poses, and the way of the robot
  kSubmap,  ///< one probability grid, its scans and its frame
  kUpdate,  ///< what one scan hit and missed, and the odds before and after
  kMatch,   ///< one scan where it was predicted and where it was matched
  kSearch,  ///< one loop search: where it looked, what it pruned, and what it found
  kGraph,   ///< nodes, submaps, the constraints between them and their residuals
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
  kInter,
  kResiduals,
  kScan,
  kFrames,
  kRobot,
  kLabels,
};

/// "map", "submap", "update", "match", "search" or "graph". Throws std::invalid_argument naming
/// these for anything else.
ViewKind ViewKindFromName(const std::string& name);
std::string ToString(ViewKind kind);

/// "grid", "misses", "hits", ... Throws std::invalid_argument naming all for anything else.
LayerKind LayerKindFromName(const std::string& name);
std::string ToString(LayerKind kind);

/// The layers that a view has, and those of them that it draws if nothing else is asked for.
const std::set<LayerKind>& LayersOf(ViewKind kind);
const std::set<LayerKind>& DefaultLayersOf(ViewKind kind);

/// What to draw of a recording, and how. Whatever is left out is chosen by the view.
struct ViewRequest {
  ViewKind view = ViewKind::kMap;
  std::optional<int> step;     ///< the state after this scan; the last one
  std::optional<NodeId> node;  ///< for update and match (then its step is the default) and search
  std::optional<SubmapId> submap;  ///< for submap, update and search
  int width = 1280;                ///< [px], 320 or more
  int height = 720;                ///< [px], 240 or more
  Theme theme = Theme::kDefault;
  std::string title;                          ///< instead of the view's own
  std::optional<std::set<LayerKind>> layers;  ///< those to draw, a part of LayersOf(view)
  std::optional<Eigen::Vector2d> center;      ///< [m] of the main panel, in the frame of the view
  std::optional<double> width_in_meters;      ///< of the main panel
};

/// The picture of a view: a pure function of its arguments. The frame is the map's for map and
/// graph, and that of the submap shown for the others. Throws std::invalid_argument that says what
/// was expected if the recording does not have what is asked for.
Scene BuildScene(const Recording& recording, const ViewRequest& request, int oversampling = 1);

}  // namespace loopscope
