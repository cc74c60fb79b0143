// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view_kinds.h"

#include <algorithm>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

constexpr ViewKind kAllViews[] = {ViewKind::kMap,   ViewKind::kSubmap, ViewKind::kUpdate,
                                  ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph,
                                  ViewKind::kTime,  ViewKind::kChart};

TEST(ViewKindTest, NamesLeadBackToTheirKinds) {
  for (const ViewKind kind : kAllViews) EXPECT_EQ(ViewKindFromName(ToString(kind)), kind);
  EXPECT_EQ(ToString(ViewKind::kSearch), "search");
}

TEST(ViewKindTest, AnUnknownNameIsRefusedWithTheKnownOnes) {
  EXPECT_EQ(MessageOf([] { ViewKindFromName("loop"); }),
            "unknown view 'loop': expected one of map, submap, update, match, search, graph, "
            "time, chart");
}

TEST(LayerKindTest, NamesLeadBackToTheirKinds) {
  for (const ViewKind view : kAllViews) {
    for (const LayerKind kind : LayersOf(view)) EXPECT_EQ(LayerKindFromName(ToString(kind)), kind);
  }
  EXPECT_THROW(LayerKindFromName("fog"), std::invalid_argument);
}

TEST(LayersOfTest, EveryDefaultLayerIsOneOfTheView) {
  for (const ViewKind view : kAllViews) {
    const auto& all = LayersOf(view);
    const auto& some = DefaultLayersOf(view);
    EXPECT_TRUE(std::includes(all.begin(), all.end(), some.begin(), some.end())) << ToString(view);
    EXPECT_FALSE(some.empty());
  }
}

}  // namespace
}  // namespace loopscope
