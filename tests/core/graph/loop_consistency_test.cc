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

TEST(MinNumSupporters, IsOneFewerForAGoodScore) {
  LoopConsistencyOptions options = Options();
  LoopCandidate loop;
  loop.min_score = 0.3;
  loop.score = 0.46;
  EXPECT_EQ(MinNumSupporters(loop, options), 2) << "no score is good";
  options.good_score_ratio = 1.5;
  EXPECT_EQ(MinNumSupporters(loop, options), 1);
  loop.score = 0.44;
  EXPECT_EQ(MinNumSupporters(loop, options), 2);
  options.min_num_supporters = 0;
  loop.score = 0.9;
  EXPECT_EQ(MinNumSupporters(loop, options), 0);
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

TEST(LoopDrifts, GiveThoseNearAlongTheWay) {
  LoopDrifts drifts;
  for (int node = 0; node < 10; ++node) drifts.Add(Loop(node, kDrift, 100.0 - 7.0 * node));
  EXPECT_EQ(drifts.size(), 10u);
  std::vector<LoopDrift> near{Loop(50, kDrift)};
  drifts.AddNear(Loop(99, kDrift, 79.0), 10.0, &near);
  std::vector<int> nodes;
  for (const LoopDrift& loop : near) nodes.push_back(loop.node.index);
  EXPECT_EQ(nodes, (std::vector<int>{50, 4, 3, 2})) << "behind what was there";
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

TEST(NumSupporters, CountsNodesThatAreNearToEachOtherAsOne) {
  LoopConsistencyOptions options = Options();
  options.min_way = 0.5;
  const LoopDrift loop = Loop(7, kDrift, 100.0);
  const auto count = [&](std::vector<double> ways) {
    std::vector<LoopDrift> others;
    for (std::size_t i = 0; i < ways.size(); ++i) {
      others.push_back(Loop(8 + static_cast<int>(i), kDrift, ways[i]));
    }
    return NumSupporters(loop, others, options);
  };
  EXPECT_EQ(count({100.4}), 0);  // too near to the node itself
  EXPECT_EQ(count({100.6}), 1);
  EXPECT_EQ(count({100.6, 101.0}), 1);
  EXPECT_EQ(count({100.6, 101.2}), 2);
}

TEST(NeighborsToCheck, AreTheNearestThatStandApart) {
  LoopConsistencyOptions options = Options();
  options.min_way = 1.0;
  options.num_checked_neighbors = 3;
  options.max_way = 4.0;
  const std::vector<double> ways{0.0, 3.0, 6.5, 7.2, 8.0, 8.4, 9.5, 11.5, 30.0};
  const auto neighbors = [&](const std::vector<NodeId>& left_out) {
    return NeighborsToCheck(NodeId{4}, left_out, ways, options);
  };
  // 3 and 5 are too near to node 4, 2 and 6 at 1.5 m come first, 7 at 3.5 m; 1 is farther than 4 m.
  EXPECT_EQ(neighbors({{0}, {1}, {2}, {3}, {5}, {6}, {7}, {8}}),
            (std::vector<NodeId>{{2}, {6}, {7}}));
  EXPECT_EQ(neighbors({{1}, {8}}), std::vector<NodeId>{});
  options.num_checked_neighbors = 1;
  EXPECT_EQ(neighbors({{2}, {6}}), std::vector<NodeId>{{2}});
}

}  // namespace
}  // namespace loopscope
