// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/slam/state.h"
#include "render/layers/labels.h"
#include "render/views/sheet.h"

namespace loopscope {

/// Colours of poses over a map.
struct PoseColors {
  Color trajectory;
  Color node;
  Color label;
  Color label_plate;
};

/// All submaps, in the colours of the panel's map.
void DrawMap(const std::vector<PlacedGrid>& grids, const MapColors& colors, MapComposer* composer,
             Sheet* sheet);

/// What is said of the selection.
struct Written {
  std::vector<Label> labels;
  std::optional<SubmapId> submap;  ///< whose id is among them
};

/// The way of the robot, its nodes, the frames of the submaps with their ids, and the robot. The
/// ids leave what is `written` free, and do not repeat it.
void DrawPoses(const MapState& state, const PoseColors& colors, const Written& written,
               Sheet* sheet);

}  // namespace loopscope
