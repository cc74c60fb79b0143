// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "core/slam/derive.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// Remembers grids of a recording that were derived, so that the next picture of it is there
/// sooner. It changes no picture. It belongs to one thread at a time.
class GridCache {
 public:
  using Grid = std::shared_ptr<const ProbabilityGrid>;

  /// Keeps a reference to `recording`, which may grow meanwhile.
  explicit GridCache(const Recording& recording) : recording_(recording) {}

  const Recording& recording() const { return recording_; }

  /// The grids of all submaps as they were after state.step. Derives those that it has not, several
  /// at a time; keeps those of finished submaps, and of the others only those of this state.
  std::vector<Grid> GridsOfState(const MapState& state);

  /// Derives the grid of one more finished submap ahead of its use. False if all are there.
  bool Prefetch();

 private:
  using Key = std::pair<int, int>;  // submap, number of its nodes

  bool IsOfFinishedSubmap(const Key& key) const;

  const Recording& recording_;
  std::map<Key, Grid> grids_;
};

}  // namespace loopscope
