// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/grid_cache.h"

#include "render/parallel.h"

namespace loopscope {

std::vector<GridCache::Grid> GridCache::GridsOfState(const MapState& state) {
  std::vector<Key> keys;
  std::vector<Grid> grids;
  std::vector<int> missing;
  for (SubmapId submap{0}; submap.index < state.num_submaps; ++submap.index) {
    keys.push_back({submap.index, NumNodesOfSubmapAfterStep(recording_, submap, state.step)});
    const auto found = grids_.find(keys.back());
    if (found == grids_.end()) missing.push_back(submap.index);
    grids.push_back(found == grids_.end() ? nullptr : found->second);
  }
  ParallelFor(static_cast<int>(missing.size()), [&](int i) {
    const auto& [submap, num_nodes] = keys[missing[i]];
    grids[submap] = std::make_shared<const ProbabilityGrid>(
        GridOfSubmap(recording_, SubmapId{submap}, num_nodes));
  });
  grids_.clear();
  for (std::size_t i = 0; i < keys.size(); ++i) grids_.emplace(keys[i], grids[i]);
  return grids;
}

}  // namespace loopscope
