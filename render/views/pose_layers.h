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
void DrawMap(const std::vector<PlacedGrid>& grids, const MapColors& colors, Sheet* sheet);

/// The way of the robot, its nodes, the frames of the submaps with their ids, and the robot. The
/// ids leave `taken`, labels that are drawn as well, free.
void DrawPoses(const MapState& state, const PoseColors& colors, const std::vector<Label>& taken,
               Sheet* sheet);

}  // namespace loopscope
