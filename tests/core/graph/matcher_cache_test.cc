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
  const SearchableGrid* SearchableOf(int submap, MatcherCache* cache) const {
    return cache->SearchableOf(SubmapId{submap}, packed_).get();
  }

  const SimulatedRoom room_;
  const PackedGrid packed_{room_.grid()};
  const std::size_t size_ = SearchableGrid(room_.grid(), kDepth).num_bytes();
};

TEST_F(MatcherCacheTest, GivesTheSameAgain) {
  MatcherCache cache(10 * size_, kDepth);
  const SearchableGrid* const first = SearchableOf(1, &cache);
  EXPECT_NE(SearchableOf(2, &cache), first);
  EXPECT_EQ(SearchableOf(1, &cache), first);
  EXPECT_EQ(cache.num_kept(), 2u);
}

TEST_F(MatcherCacheTest, GivesTheGridOfTheSubmap) {
  MatcherCache cache(10 * size_, kDepth);
  EXPECT_EQ(SearchableOf(1, &cache)->grid.cells(), room_.grid().cells());
}

TEST_F(MatcherCacheTest, DropsThoseThatWereAskedForTheLongestAgo) {
  MatcherCache cache(2 * size_, kDepth);
  const SearchableGrid* const first = SearchableOf(1, &cache);
  SearchableOf(2, &cache);
  SearchableOf(1, &cache);
  SearchableOf(3, &cache);
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 2u) << "the second is gone";
  EXPECT_EQ(SearchableOf(1, &cache), first);
}

TEST_F(MatcherCacheTest, CountsTheGridsThatSearchesAskFor) {
  MatcherCache cache(size_, kDepth);
  const auto searchable = cache.SearchableOf(SubmapId{1}, packed_);
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 1u);
  searchable->matcher.Search(room_.ScanAt(Pose2(2.0, 0.8, 0.4)), Pose2(2.0, 0.8, 0.4), 1.0, 0.1,
                             0.3);
  EXPECT_GT(searchable->num_bytes(), size_);
  cache.Trim();
  EXPECT_EQ(cache.num_kept(), 0u);
  EXPECT_GT(searchable->num_bytes(), size_) << "whoever has it may go on with it";
}

}  // namespace
}  // namespace loopscope
