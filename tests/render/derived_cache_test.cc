// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/derived_cache.h"

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

/// The first seconds of the small loop: a few submaps.
const Recording& FewSubmaps() {
  static const Recording recording = [] {
    ScanLog log = SimulateSmallLoop().log;
    log.scans.resize(60);
    return MapLog(log, SmallLoopOptions());
  }();
  return recording;
}

TEST(DerivedCacheTest, HasTheGridsOfTheState) {
  const Recording& recording = FewSubmaps();
  const MapState state = StateAfterStep(recording, 40);
  DerivedCache cache(recording);
  const auto grids = cache.GridsOfState(state);
  ASSERT_EQ(static_cast<int>(grids.size()), state.num_submaps);
  ASSERT_GE(state.num_submaps, 3);
  for (int i = 0; i < state.num_submaps; ++i) {
    const int num_nodes = NumNodesOfSubmapAfterStep(recording, SubmapId{i}, 40);
    EXPECT_EQ(grids[i]->cells(), GridOfSubmap(recording, SubmapId{i}, num_nodes).cells());
  }
}

TEST(DerivedCacheTest, GrowsTheGridsOfAnEarlierStateIntoThoseOfTheNext) {
  const Recording& recording = FewSubmaps();
  DerivedCache stepped(recording);
  for (int step = 0; step < 60; step += 3) {
    const MapState state = StateAfterStep(recording, step);
    const auto grids = stepped.GridsOfState(state);
    const auto expected = DerivedCache(recording).GridsOfState(state);
    ASSERT_EQ(grids.size(), expected.size());
    for (std::size_t i = 0; i < grids.size(); ++i) {
      EXPECT_EQ(grids[i]->cells(), expected[i]->cells()) << step << " submap " << i;
    }
  }
}

TEST(DerivedCacheTest, DerivesNoGridTwiceAndFollowsTheStateInBothDirections) {
  const Recording& recording = FewSubmaps();
  DerivedCache cache(recording);
  const auto later = cache.GridsOfState(StateAfterStep(recording, 59));
  const auto again = cache.GridsOfState(StateAfterStep(recording, 59));
  EXPECT_EQ(again, later);
  const auto earlier = cache.GridsOfState(StateAfterStep(recording, 40));
  EXPECT_EQ(earlier[0], later[0]) << "submap 0 is finished at both";
  EXPECT_NE(earlier.back(), later[earlier.size() - 1]) << "this one grew in between";
  EXPECT_LT(earlier.size(), later.size());
}

TEST(DerivedCacheTest, KeepsWhatWasUsedLastWithinItsBudget) {
  const Recording& recording = FewSubmaps();
  DerivedCache cache(recording, /*max_bytes=*/1);
  const auto first = cache.GridsOfState(StateAfterStep(recording, 59));
  EXPECT_EQ(cache.GridsOfState(StateAfterStep(recording, 59)), first) << "all of the last state";
  cache.GridsOfState(StateAfterStep(recording, 0));
  EXPECT_FALSE(cache.Prefetch()) << "no room";
  EXPECT_NE(cache.GridsOfState(StateAfterStep(recording, 59))[0], first[0]) << "derived anew";
}

TEST(DerivedCacheTest, PrefetchesTheFinishedSubmapsFromTheNewestOneOfTheStateOn) {
  const Recording& recording = FewSubmaps();
  DerivedCache cache(recording);
  cache.GridsOfState(StateAfterStep(recording, 0));
  int num_finished = 0;
  for (const Submap& submap : recording.submaps()) num_finished += submap.finished_step >= 0;
  for (int i = 0; i < num_finished; ++i) EXPECT_TRUE(cache.Prefetch()) << i;
  EXPECT_FALSE(cache.Prefetch());
}

TEST(DerivedCacheTest, MakesASearchOnce) {
  const Recording& recording = FewSubmaps();
  DerivedCache cache(recording);
  const NodeId node{static_cast<int>(recording.nodes().size()) - 1};
  const auto search = cache.SearchOf(SubmapId{0}, node);
  ASSERT_NE(search, nullptr);
  EXPECT_EQ(cache.SearchOf(SubmapId{0}, node), search);
  EXPECT_EQ(cache.SearchOf(SubmapId{0}, NodeId{0}), nullptr) << "the node is in the submap";
  EXPECT_EQ(cache.SearchOf(SubmapId{0}, node)->trace.nodes.size(), search->trace.nodes.size());
}

}  // namespace
}  // namespace loopscope
