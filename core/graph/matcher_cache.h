// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "core/geometry/id.h"
#include "core/matching/branch_and_bound.h"

namespace loopscope {

/// Matchers of the submaps that were searched last: their precomputed grids take more memory than
/// all else, and are quickly made again. May be used by several threads at once.
class MatcherCache {
 public:
  /// Holds at most `capacity` >= 1 matchers with precomputed grids of `depth` heights.
  MatcherCache(int capacity, int depth) : capacity_(capacity), depth_(depth) {}

  /// The matcher of the finished submap `id` whose grid is `grid`.
  std::shared_ptr<const BranchAndBoundMatcher> Get(SubmapId id, const ProbabilityGrid& grid);

 private:
  struct Entry {
    SubmapId id;
    std::once_flag made;
    std::shared_ptr<const BranchAndBoundMatcher> matcher;
  };
  std::shared_ptr<Entry> FindOrAdd(SubmapId id);

  int capacity_;
  int depth_;
  std::mutex mutex_;
  std::list<std::shared_ptr<Entry>> entries_;  ///< last used first
};

}  // namespace loopscope
