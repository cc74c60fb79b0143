// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/search_part.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

SearchNode Node(int parent, int height, int angle, SearchFate fate) {
  SearchNode node;
  node.parent = parent;
  node.height = height;
  node.angle_index = angle;
  node.fate = fate;
  return node;
}

/// Two start nodes; the first is expanded and has two leaves, the first of which wins.
SearchTrace SmallTrace() {
  SearchTrace trace;
  trace.window = {Pose2(), 1, 2, 0.05, DegreesToRadians(0.5)};
  trace.nodes = {Node(-1, 1, 0, SearchFate::kExpanded), Node(-1, 1, 2, SearchFate::kPruned),
                 Node(0, 0, 0, SearchFate::kImproved), Node(0, 0, 0, SearchFate::kPruned)};
  trace.visits = {0, 2, 3, 1};
  trace.winner = 2;
  return trace;
}

TEST(SearchPartTest, OfAllVisitsIsTheWholeTree) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace);
  EXPECT_EQ(part.num_visits(), 4);
  EXPECT_EQ(part.num_scored(), 4);
  EXPECT_EQ(part.num_expanded(), 2);
  EXPECT_EQ(part.num_pruned(), 2);
  EXPECT_EQ(part.best_leaf(), 2);
  EXPECT_EQ(part.last(), -1);
  EXPECT_TRUE(part.WasPruned(1));
  EXPECT_TRUE(part.WasExpanded(2));
}

TEST(SearchPartTest, BeforeTheFirstVisitOnlyTheStartNodesAreScored) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace, {0, {}, {}});
  EXPECT_EQ(part.num_scored(), 2);
  EXPECT_EQ(part.best_leaf(), -1);
  EXPECT_EQ(part.last(), -1);
  EXPECT_FALSE(part.WasDecided(0));
  EXPECT_TRUE(part.Shows(1));
  EXPECT_FALSE(part.Shows(2));
}

TEST(SearchPartTest, AnExpansionScoresTheChildrenBeforeTheyAreVisited) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace, {1, {}, {}});
  EXPECT_EQ(part.num_scored(), 4);
  EXPECT_EQ(part.num_expanded(), 1);
  EXPECT_EQ(part.num_pruned(), 0);
  EXPECT_EQ(part.last(), 0);
  EXPECT_EQ(part.best_leaf(), -1);
  EXPECT_FALSE(part.WasExpanded(2));
  EXPECT_FALSE(part.WasPruned(1));
}

TEST(SearchPartTest, ShowsOnlyTheAngleAskedFor) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace, {{}, {}, 2});
  EXPECT_FALSE(part.Shows(0));
  EXPECT_TRUE(part.Shows(1));
  EXPECT_FALSE(part.Shows(-1));
  EXPECT_EQ(part.num_scored(), 4);
}

TEST(SearchPartTest, RefusesWhatTheSearchDoesNotHave) {
  const SearchTrace trace = SmallTrace();
  EXPECT_EQ(MessageOf([&] {
              SearchPart(trace, {5, {}, {}});
            }),
            "visits 5 of the search: expected 0 to 4");
  EXPECT_EQ(MessageOf([&] {
              SearchPart(trace, {-1, {}, {}});
            }),
            "visits -1 of the search: expected 0 to 4");
  EXPECT_EQ(MessageOf([&] {
              SearchPart(trace, {{}, 2, {}});
            }),
            "height 2 of the search: expected 0 to 1");
  EXPECT_EQ(MessageOf([&] {
              SearchPart(trace, {{}, {}, -3});
            }),
            "angle index -3 of the search: expected -2 to 2");
}

}  // namespace
}  // namespace loopscope
