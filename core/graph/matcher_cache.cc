// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/matcher_cache.h"

namespace loopscope {

std::shared_ptr<const SearchableGrid> MatcherCache::SearchableOf(SubmapId submap,
                                                                 const PackedGrid& grid) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = kept_.find(submap);
  if (found != kept_.end()) {
    uses_.splice(uses_.begin(), uses_, found->second.use);
    return found->second.searchable;
  }
  uses_.push_front(submap);
  const auto searchable = std::make_shared<const SearchableGrid>(grid.Unpack(), depth_);
  kept_.emplace(submap, Kept{searchable, uses_.begin()});
  return searchable;
}

void MatcherCache::Trim() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t num_bytes = 0;
  for (auto use = uses_.begin(); use != uses_.end();) {
    const auto kept = kept_.find(*use);
    num_bytes += kept->second.searchable->num_bytes();
    if (num_bytes <= max_bytes_) {
      ++use;
      continue;
    }
    kept_.erase(kept);
    use = uses_.erase(use);
  }
}

}  // namespace loopscope
