// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/grid_cache.h"

#include <iterator>

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
  for (auto i = grids_.begin(); i != grids_.end();) {
    i = IsOfFinishedSubmap(i->first) ? std::next(i) : grids_.erase(i);
  }
  for (std::size_t i = 0; i < keys.size(); ++i) grids_.emplace(keys[i], grids[i]);
  return grids;
}

bool GridCache::Prefetch() {
  for (SubmapId id{0}; id.index < static_cast<int>(recording_.submaps().size()); ++id.index) {
    const Key key{id.index, recording_.submap(id).num_nodes};
    if (!IsOfFinishedSubmap(key) || grids_.count(key) > 0) continue;
    grids_.emplace(key, std::make_shared<const ProbabilityGrid>(GridOfSubmap(recording_, id)));
    return true;
  }
  return false;
}

bool GridCache::IsOfFinishedSubmap(const Key& key) const {
  const Submap& submap = recording_.submaps()[key.first];
  return submap.finished_step >= 0 && submap.num_nodes == key.second;
}

}  // namespace loopscope
