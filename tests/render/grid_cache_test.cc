// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/grid_cache.h"

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

TEST(GridCacheTest, HasTheGridsOfTheState) {
  const Recording& recording = FewSubmaps();
  const MapState state = StateAfterStep(recording, 40);
  GridCache cache(recording);
  const auto grids = cache.GridsOfState(state);
  ASSERT_EQ(static_cast<int>(grids.size()), state.num_submaps);
  ASSERT_GE(state.num_submaps, 3);
  for (int i = 0; i < state.num_submaps; ++i) {
    const int num_nodes = NumNodesOfSubmapAfterStep(recording, SubmapId{i}, 40);
    EXPECT_EQ(grids[i]->cells(), GridOfSubmap(recording, SubmapId{i}, num_nodes).cells());
  }
}

TEST(GridCacheTest, DerivesNoGridTwiceAndFollowsTheStateInBothDirections) {
  const Recording& recording = FewSubmaps();
  GridCache cache(recording);
  const auto later = cache.GridsOfState(StateAfterStep(recording, 59));
  const auto again = cache.GridsOfState(StateAfterStep(recording, 59));
  EXPECT_EQ(again, later);
  const auto earlier = cache.GridsOfState(StateAfterStep(recording, 40));
  EXPECT_EQ(earlier[0], later[0]) << "submap 0 is finished at both";
  EXPECT_NE(earlier.back(), later[earlier.size() - 1]) << "this one grew in between";
  EXPECT_LT(earlier.size(), later.size());
}

}  // namespace
}  // namespace loopscope
