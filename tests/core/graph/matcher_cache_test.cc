// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/matcher_cache.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr int kDepth = 3;

ProbabilityGrid SmallGrid() {
  ProbabilityGrid grid(0.05);
  grid.GrowToInclude({{0, 0}, 4, 4});
  grid.Update({{1, 2}}, OddsUpdate(0.7));
  return grid;
}

TEST(MatcherCache, GivesTheSameMatcherTwice) {
  MatcherCache cache(2, kDepth);
  const ProbabilityGrid grid = SmallGrid();
  EXPECT_EQ(cache.Get(SubmapId{0}, grid), cache.Get(SubmapId{0}, grid));
}

TEST(MatcherCache, ForgetsTheOneThatWasUsedLongestAgo) {
  MatcherCache cache(2, kDepth);
  const ProbabilityGrid grid = SmallGrid();
  const std::weak_ptr<const BranchAndBoundMatcher> first = cache.Get(SubmapId{0}, grid);
  const std::weak_ptr<const BranchAndBoundMatcher> second = cache.Get(SubmapId{1}, grid);
  cache.Get(SubmapId{0}, grid);
  cache.Get(SubmapId{2}, grid);
  EXPECT_FALSE(first.expired());
  EXPECT_TRUE(second.expired());
}

TEST(MatcherCache, LeavesAMatcherToWhoStillUsesIt) {
  MatcherCache cache(1, kDepth);
  const ProbabilityGrid grid = SmallGrid();
  const auto used = cache.Get(SubmapId{0}, grid);
  cache.Get(SubmapId{1}, grid);
  const SearchOutcome outcome = used->Search({{0.05, 0.1}}, Pose2(), 0.1, 0.1, 0.0);
  EXPECT_TRUE(outcome.winner.has_value());
}

}  // namespace
}  // namespace loopscope
