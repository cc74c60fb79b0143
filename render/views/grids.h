// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/slam/state.h"
#include "render/annotation.h"
#include "render/derived_cache.h"
#include "render/layers/map_image.h"

namespace loopscope {

/// The grids of all submaps as they were after state.step, at their poses in `state`.
std::vector<PlacedGrid> PlacedGridsOf(DerivedCache* cache, const MapState& state);

/// Where all known cells of `grids` lie.
Extent ExtentOf(const std::vector<PlacedGrid>& grids);

/// The scale from free to occupied.
ColorBar OccupancyBar(const MapColors& colors);

/// The entry for what no scan has seen.
LegendEntry UnknownEntry(const MapColors& colors);

}  // namespace loopscope
