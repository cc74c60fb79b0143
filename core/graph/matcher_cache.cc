// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/matcher_cache.h"

#include <algorithm>

namespace loopscope {

std::shared_ptr<const BranchAndBoundMatcher> MatcherCache::Get(SubmapId id,
                                                               const ProbabilityGrid& grid) {
  const std::shared_ptr<Entry> entry = FindOrAdd(id);
  std::call_once(entry->made, [&] {
    entry->matcher = std::make_shared<const BranchAndBoundMatcher>(grid, depth_);
  });
  return entry->matcher;
}

std::shared_ptr<MatcherCache::Entry> MatcherCache::FindOrAdd(SubmapId id) {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [&](const auto& entry) { return entry->id == id; });
  if (found != entries_.end()) {
    entries_.splice(entries_.begin(), entries_, found);
    return entries_.front();
  }
  entries_.push_front(std::make_shared<Entry>());
  entries_.front()->id = id;
  if (static_cast<int>(entries_.size()) > capacity_) entries_.pop_back();
  return entries_.front();
}

}  // namespace loopscope
