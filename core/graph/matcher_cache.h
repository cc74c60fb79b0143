// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <mutex>

#include "core/geometry/id.h"
#include "core/grid/packed_grid.h"
#include "core/matching/branch_and_bound.h"

namespace loopscope {

/// A finished submap made ready to be searched.
struct SearchableGrid {
  SearchableGrid(ProbabilityGrid unpacked, int depth)
      : grid(std::move(unpacked)), matcher(grid, depth) {}

  std::size_t num_bytes() const {
    return grid.cells().size() * sizeof(CellValue) + matcher.num_bytes();
  }

  ProbabilityGrid grid;
  BranchAndBoundMatcher matcher;
};

/// Grids and matchers of the submaps that were searched last, for their precomputed grids take time
/// to make and more memory than all else. What is kept changes no result. May be used by several
/// threads.
class MatcherCache {
 public:
  /// `max_bytes` are kept at most, `depth` is that of the matchers.
  MatcherCache(std::size_t max_bytes, int depth) : max_bytes_(max_bytes), depth_(depth) {}

  /// Makes one if none is kept. `grid` is that of the submap, and always the same.
  std::shared_ptr<const SearchableGrid> SearchableOf(SubmapId submap, const PackedGrid& grid);

  /// Drops those that were not asked for the longest, until the others fit. To be called after
  /// searches, which let matchers grow.
  void Trim();

  std::size_t num_kept() const { return kept_.size(); }

 private:
  struct Kept {
    std::shared_ptr<const SearchableGrid> searchable;
    std::list<SubmapId>::iterator use;
  };

  std::size_t max_bytes_;
  int depth_;
  std::mutex mutex_;
  std::list<SubmapId> uses_;  ///< those kept, the last one asked for first
  std::map<SubmapId, Kept> kept_;
};

}  // namespace loopscope
