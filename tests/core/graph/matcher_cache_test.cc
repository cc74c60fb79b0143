// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/matcher_cache.h"

#include <gtest/gtest.h>

#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

constexpr int kDepth = 4;

class MatcherCacheTest : public ::testing::Test {
 protected:
  const BranchAndBoundMatcher* MatcherOf(int submap, MatcherCache* cache) const {
    return cache->MatcherOf(SubmapId{submap}, room_.grid()).get();
  }

  const SimulatedRoom room_;
  const std::size_t size_ = BranchAndBoundMatcher(room_.grid(), kDepth).num_bytes();
};

TEST_F(MatcherCacheTest, GivesTheSameMatcherAgain) {
  MatcherCache cache(10 * size_, kDepth);
  const BranchAndBoundMatcher* const first = MatcherOf(1, &cache);
  EXPECT_NE(MatcherOf(2, &cache), first);
  EXPECT_EQ(MatcherOf(1, &cache), first);
  EXPECT_EQ(cache.num_kept(), 2u);
}

TEST_F(MatcherCacheTest, DropsThoseThatWereAskedForTheLongestAgo) {
  MatcherCache cache(2 * size_, kDepth);
  const BranchAndBoundMatcher* const first = MatcherOf(1, &cache);
  MatcherOf(2, &cache);
  MatcherOf(1, &cache);
  MatcherOf(3, &cache);
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 2u) << "the second is gone";
  EXPECT_EQ(MatcherOf(1, &cache), first);
}

TEST_F(MatcherCacheTest, CountsTheGridsThatSearchesAskFor) {
  MatcherCache cache(size_, kDepth);
  const auto matcher = cache.MatcherOf(SubmapId{1}, room_.grid());
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 1u);
  matcher->Search(room_.ScanAt(Pose2(2.0, 0.8, 0.4)), Pose2(2.0, 0.8, 0.4), 1.0, 0.1, 0.3);
  EXPECT_GT(matcher->num_bytes(), size_);
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 0u);
  EXPECT_GT(matcher->num_bytes(), size_) << "whoever has it may go on with it";
}

}  // namespace
}  // namespace loopscope
