// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/matcher_cache.h"

namespace loopscope {

std::shared_ptr<const BranchAndBoundMatcher> MatcherCache::MatcherOf(SubmapId submap,
                                                                     const ProbabilityGrid& grid) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = matchers_.find(submap);
  if (found != matchers_.end()) {
    uses_.splice(uses_.begin(), uses_, found->second.use);
    return found->second.matcher;
  }
  uses_.push_front(submap);
  const auto matcher = std::make_shared<const BranchAndBoundMatcher>(grid, depth_);
  matchers_.emplace(submap, Kept{matcher, uses_.begin()});
  return matcher;
}

void MatcherCache::Trim() {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::size_t num_bytes = 0;
  for (auto use = uses_.begin(); use != uses_.end();) {
    const auto kept = matchers_.find(*use);
    num_bytes += kept->second.matcher->num_bytes();
    if (num_bytes <= max_bytes_) {
      ++use;
      continue;
    }
    matchers_.erase(kept);
    use = uses_.erase(use);
  }
}

}  // namespace loopscope
