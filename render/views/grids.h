// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/slam/state.h"
#include "render/annotation.h"
#include "render/grid_cache.h"
#include "render/layers/map_image.h"

namespace loopscope {

/// The grids of all submaps as they were after state.step, at their poses in `state`.
std::vector<PlacedGrid> PlacedGridsOf(GridCache* cache, const MapState& state);

/// Where all known cells of `grids` lie.
Extent ExtentOf(const std::vector<PlacedGrid>& grids);

/// The scale from free to occupied.
ColorBar OccupancyBar(const MapColors& colors);

/// The entry for what no scan has seen.
LegendEntry UnknownEntry(const MapColors& colors);

/// "12.3 cm" or "4.56 m"; `length` in [m].
std::string LengthText(double length);

/// "40817" or "8.45 million".
std::string CountText(double count);

/// "0.41°"; `radians` in any range.
std::string AngleText(double radians);

}  // namespace loopscope
