// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/slam/derive.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

class MapComposer;

/// Remembers what was derived of a recording, so that the next picture of it is there sooner. It
/// changes no picture. It belongs to one thread at a time.
class DerivedCache {
 public:
  using Grid = std::shared_ptr<const ProbabilityGrid>;
  using Search = std::shared_ptr<const SearchReplay>;

  static constexpr std::size_t kUsualMaxBytes = std::size_t{1} << 30;

  /// Keeps a reference to `recording`, which may grow meanwhile, and grids of up to `max_bytes`:
  /// those that were used last, and all of the last state whatever they take.
  explicit DerivedCache(const Recording& recording, std::size_t max_bytes = kUsualMaxBytes);
  ~DerivedCache();

  const Recording& recording() const { return recording_; }

  /// The grids of all submaps as they were after state.step. Derives those that it has not, several
  /// at a time; keeps those of finished submaps, and of the others only those of this state.
  std::vector<Grid> GridsOfState(const MapState& state);

  /// Derives the grid of one more finished submap ahead of its use: of the one nearest to the
  /// newest submap of the last state. False if all are there, or no more have room.
  bool Prefetch();

  /// The search of the pair as ReplaySearch makes it, null where that gives nothing. The last one
  /// is kept.
  Search SearchOf(SubmapId submap, NodeId node);

  /// For the map of all submaps.
  MapComposer& map_composer() { return *map_composer_; }

 private:
  using Key = std::pair<int, int>;  // submap, number of its nodes

  struct Entry {
    Grid grid;
    std::int64_t last_use = 0;
  };

  /// The grid that the same submap had with fewer nodes, and with how many.
  std::optional<std::pair<int, Grid>> EarlierOf(const Key& key) const;
  bool IsOfFinishedSubmap(const Key& key) const;
  void Keep(const Key& key, const Grid& grid);
  void EvictUnfinished();
  void EvictOldest();

  const Recording& recording_;
  std::size_t max_bytes_;
  std::size_t bytes_ = 0;  // of all grids
  std::int64_t uses_ = 0;  // counts states
  int newest_ = 0;         // submap of the last state
  std::map<Key, Entry> grids_;
  std::pair<SubmapId, NodeId> searched_;
  Search search_;  // of `searched_`
  std::unique_ptr<MapComposer> map_composer_;
};

}  // namespace loopscope
