// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/id.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(Ids, AreOrderedByTheirIndex) {
  EXPECT_TRUE(NodeId{2} < NodeId{10});
  EXPECT_FALSE(NodeId{2} < NodeId{2});
  EXPECT_TRUE(SubmapId{2} < SubmapId{10});
  EXPECT_FALSE(SubmapId{10} < SubmapId{2});
}

TEST(Ids, AreEqualIfTheirIndicesAre) {
  EXPECT_TRUE(NodeId{3} == NodeId{3});
  EXPECT_FALSE(NodeId{3} == NodeId{4});
  EXPECT_TRUE(SubmapId{3} != SubmapId{4});
  EXPECT_FALSE(SubmapId{3} != SubmapId{3});
}

TEST(Ids, PrintAsTrajectoryAndIndex) {
  EXPECT_EQ(ToString(NodeId{812}), "(0, 812)");
  EXPECT_EQ(ToString(SubmapId{7}), "(0, 7)");
}

}  // namespace
}  // namespace loopscope
