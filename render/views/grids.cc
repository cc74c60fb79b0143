// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/grids.h"

namespace loopscope {

std::vector<PlacedGrid> PlacedGridsOf(DerivedCache* cache, const MapState& state) {
  std::vector<PlacedGrid> placed;
  for (const DerivedCache::Grid& grid : cache->GridsOfState(state)) {
    placed.push_back({grid, state.global_from_submap[placed.size()]});
  }
  return placed;
}

Extent ExtentOf(const std::vector<PlacedGrid>& grids) {
  Extent extent;
  for (const PlacedGrid& grid : grids) extent.extend(ExtentOf(grid));
  return extent;
}

ColorBar OccupancyBar(const MapColors& colors) {
  return {"probability of an obstacle",
          {{colors.free, colors.occupied}},
          {{0.0, "0.1"}, {0.5, "0.5"}, {1.0, "0.9"}}};
}

LegendEntry UnknownEntry(const MapColors& colors) {
  return {{Swatch::Kind::kFill, colors.unknown, colors.unknown}, "never seen"};
}

}  // namespace loopscope
