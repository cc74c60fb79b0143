// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/derived_cache.h"

#include <algorithm>
#include <iterator>

#include "render/layers/map_image.h"
#include "render/parallel.h"

namespace loopscope {
namespace {

std::size_t BytesOf(const ProbabilityGrid& grid) { return grid.cells().size() * sizeof(CellValue); }

/// Submaps that follow each other, to be derived in one go.
struct Row {
  int first = 0;
  int count = 0;
};

/// All of `submaps`, which ascend; in rows long enough to cast few scans twice, and short enough to
/// keep many threads busy.
std::vector<Row> RowsOf(const std::vector<int>& submaps) {
  constexpr int kMaxCount = 8;
  std::vector<Row> rows;
  for (const int submap : submaps) {
    const bool follows = !rows.empty() && rows.back().first + rows.back().count == submap;
    if (follows && rows.back().count < kMaxCount) {
      ++rows.back().count;
    } else {
      rows.push_back({submap, 1});
    }
  }
  return rows;
}

}  // namespace

DerivedCache::DerivedCache(const Recording& recording, std::size_t max_bytes)
    : recording_(recording),
      max_bytes_(max_bytes),
      map_composer_(std::make_unique<MapComposer>()) {}

DerivedCache::~DerivedCache() = default;

std::vector<DerivedCache::Grid> DerivedCache::GridsOfState(const MapState& state) {
  std::vector<Key> keys;
  std::vector<Grid> grids;
  std::vector<int> missing;
  for (SubmapId submap{0}; submap.index < state.num_submaps; ++submap.index) {
    keys.push_back({submap.index, NumNodesOfSubmapAfterStep(recording_, submap, state.step)});
    const auto found = grids_.find(keys.back());
    if (found == grids_.end()) missing.push_back(submap.index);
    grids.push_back(found == grids_.end() ? nullptr : found->second.grid);
  }
  const double resolution = recording_.options().trajectory_builder_2d.submaps.grid_resolution;
  const std::vector<Row> rows = RowsOf(missing);
  ParallelFor(static_cast<int>(rows.size()), [&](int i) {
    const Row& row = rows[i];
    std::vector<int> begins;
    std::vector<int> ends;
    std::vector<ProbabilityGrid> derived;
    for (int k = 0; k < row.count; ++k) {
      const Key& key = keys[row.first + k];
      const auto earlier = EarlierOf(key);
      begins.push_back(earlier ? earlier->first : 0);
      ends.push_back(key.second);
      derived.push_back(earlier ? *earlier->second : ProbabilityGrid(resolution));
    }
    GrowGrids(recording_, SubmapId{row.first}, begins, ends, &derived);
    for (int k = 0; k < row.count; ++k) {
      grids[row.first + k] = std::make_shared<const ProbabilityGrid>(std::move(derived[k]));
    }
  });
  ++uses_;
  newest_ = state.num_submaps - 1;
  EvictUnfinished();
  for (std::size_t i = 0; i < keys.size(); ++i) Keep(keys[i], grids[i]);
  EvictOldest();
  return grids;
}

bool DerivedCache::Prefetch() {
  const int count = static_cast<int>(recording_.submaps().size());
  for (int distance = 0; distance < count && bytes_ < max_bytes_; ++distance) {
    for (const SubmapId id : {SubmapId{newest_ + distance}, SubmapId{newest_ - distance}}) {
      if (id.index < 0 || id.index >= count) continue;
      const Key key{id.index, recording_.submap(id).num_nodes};
      if (!IsOfFinishedSubmap(key) || grids_.count(key) > 0) continue;
      Keep(key, std::make_shared<const ProbabilityGrid>(GridOfSubmap(recording_, id)));
      return true;
    }
  }
  return false;
}

DerivedCache::Search DerivedCache::SearchOf(SubmapId submap, NodeId node) {
  if (search_ && searched_ == std::pair(submap, node)) return search_;
  auto replay = ReplaySearch(recording_, submap, node);
  searched_ = {submap, node};
  search_ = replay ? std::make_shared<const SearchReplay>(std::move(*replay)) : nullptr;
  return search_;
}

std::optional<std::pair<int, DerivedCache::Grid>> DerivedCache::EarlierOf(const Key& key) const {
  auto next = grids_.lower_bound(key);
  if (next == grids_.begin()) return std::nullopt;
  const auto& [earlier, entry] = *--next;
  if (earlier.first != key.first) return std::nullopt;
  return std::pair(earlier.second, entry.grid);
}

bool DerivedCache::IsOfFinishedSubmap(const Key& key) const {
  const Submap& submap = recording_.submaps()[key.first];
  return submap.finished_step >= 0 && submap.num_nodes == key.second;
}

void DerivedCache::Keep(const Key& key, const Grid& grid) {
  Entry& entry = grids_[key];
  if (!entry.grid) bytes_ += BytesOf(*grid);
  entry = {grid, uses_};
}

void DerivedCache::EvictUnfinished() {
  for (auto i = grids_.begin(); i != grids_.end();) {
    const bool stays = IsOfFinishedSubmap(i->first);
    if (!stays) bytes_ -= BytesOf(*i->second.grid);
    i = stays ? std::next(i) : grids_.erase(i);
  }
}

void DerivedCache::EvictOldest() {
  while (bytes_ > max_bytes_) {
    const auto oldest = std::min_element(
        grids_.begin(), grids_.end(),
        [](const auto& a, const auto& b) { return a.second.last_use < b.second.last_use; });
    if (oldest->second.last_use == uses_) return;
    bytes_ -= BytesOf(*oldest->second.grid);
    grids_.erase(oldest);
  }
}

}  // namespace loopscope
