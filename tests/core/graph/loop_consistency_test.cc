// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_consistency.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

LoopConsistencyOptions Options() {
  LoopConsistencyOptions options;
  options.min_num_supporters = 2;
  options.max_way = 20.0;
  options.max_distance = 0.2;
  options.max_distance_per_meter = 0.02;
  options.max_angle = 0.03;
  return options;
}

/// A loop of a node that stands at (50 m, 10 m) in the local frame.
LoopDrift Loop(int node, const Pose2& drift, double node_way = 100.0, double submap_way = 5.0) {
  return {NodeId{node}, Pose2(50.0, 10.0, 1.0), drift, node_way, submap_way};
}

const Pose2 kDrift(1.0, -0.5, 0.1);

/// `drift` and a motion of the node from where it leads to.
Pose2 AndThen(const Pose2& drift, const Pose2& motion_of_node) {
  const Pose2 local_from_node = Loop(0, drift).local_from_node;
  return drift * local_from_node * motion_of_node * local_from_node.Inverse();
}

TEST(Agree, ComparesWhereTheDriftsLeadTheNode) {
  const LoopDrift loop = Loop(7, kDrift);
  EXPECT_TRUE(Agree(loop, Loop(8, kDrift), Options()));
  EXPECT_TRUE(Agree(loop, Loop(8, AndThen(kDrift, Pose2(0.0, 0.19, 0.02))), Options()));
  EXPECT_FALSE(Agree(loop, Loop(8, AndThen(kDrift, Pose2(0.0, 0.21, 0.0))), Options()));
}

TEST(Agree, ComparesTurns) {
  const LoopDrift loop = Loop(7, kDrift);
  EXPECT_TRUE(Agree(loop, Loop(8, AndThen(kDrift, Pose2(0.0, 0.0, 0.029))), Options()));
  EXPECT_FALSE(Agree(loop, Loop(8, AndThen(kDrift, Pose2(0.0, 0.0, -0.031))), Options()));
}

TEST(Agree, AllowsForDriftOnTheWayBetweenTheLoops) {
  const LoopDrift loop = Loop(7, kDrift);
  const Pose2 other = AndThen(kDrift, Pose2(0.5, 0.0, 0.0));
  EXPECT_FALSE(Agree(loop, Loop(8, other, 107.0, 12.0), Options()));  // 0.48 m allowed
  EXPECT_TRUE(Agree(loop, Loop(8, other, 108.0, 13.0), Options()));   // 0.52 m
  EXPECT_TRUE(Agree(loop, Loop(8, other, 92.0, 13.0), Options()));    // as well before it
}

TEST(Agree, SaysNothingOfLoopsThatAreFarFromEachOther) {
  const LoopDrift loop = Loop(7, kDrift);
  EXPECT_TRUE(Agree(loop, Loop(8, kDrift, 119.9, 5.0), Options()));
  EXPECT_FALSE(Agree(loop, Loop(8, kDrift, 120.1, 5.0), Options()));
  EXPECT_FALSE(Agree(loop, Loop(8, kDrift, 79.9, 5.0), Options()));
  EXPECT_FALSE(Agree(loop, Loop(8, kDrift, 100.0, 25.1), Options()));
}

TEST(NumSupporters, CountsNodesAndNotLoops) {
  const LoopDrift loop = Loop(7, kDrift);
  EXPECT_EQ(NumSupporters(loop, {}, Options()), 0);
  EXPECT_EQ(NumSupporters(loop, {Loop(8, kDrift), Loop(9, kDrift), Loop(8, kDrift)}, Options()), 2);
}

TEST(NumSupporters, CountsNeitherTheNodeItselfNorThoseThatDisagree) {
  const LoopDrift loop = Loop(7, kDrift);
  const LoopDrift far_off = Loop(9, AndThen(kDrift, Pose2(3.0, 0.0, 0.0)));
  EXPECT_EQ(NumSupporters(loop, {loop, Loop(7, kDrift), far_off}, Options()), 0);
}

}  // namespace
}  // namespace loopscope
