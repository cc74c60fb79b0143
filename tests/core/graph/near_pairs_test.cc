// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/near_pairs.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

constexpr double kReach = 12.0;
constexpr int kNodesPerSubmap = 8;

Pose2 AnyPose(Random* random) {
  return Pose2(random->Uniform(-150.0, 150.0), random->Uniform(-150.0, 150.0),
               random->Uniform(-M_PI, M_PI));
}

/// Submaps of nodes that lie metres apart, wherever.
GraphState AnyGraph(Random* random) {
  GraphState graph;
  for (int submap = 0; submap < 40; ++submap) {
    GraphSubmap data;
    data.first_node = NodeId{static_cast<int>(graph.nodes.size())};
    data.num_nodes = kNodesPerSubmap;
    const Pose2 global_from_submap = AnyPose(random);
    for (int i = 0; i < kNodesPerSubmap; ++i) {
      const Pose2 submap_from_node(random->Uniform(-8.0, 8.0), random->Uniform(-3.0, 3.0), 0.0);
      data.node_box.extend(submap_from_node.translation);
      graph.nodes.emplace_back();
      graph.global_from_node.push_back(global_from_submap * submap_from_node);
    }
    graph.submaps.push_back(data);
    graph.global_from_submap.push_back(global_from_submap);
  }
  return graph;
}

NearPairs PairsOf(const GraphState& graph) {
  NearPairs pairs(kReach);
  for (int i = 0; i < static_cast<int>(graph.nodes.size()); ++i) pairs.AddNode(NodeId{i}, graph);
  for (int i = 0; i < static_cast<int>(graph.submaps.size()); ++i) {
    pairs.AddFinishedSubmap(SubmapId{i}, graph);
  }
  return pairs;
}

bool Holds(const std::vector<int>& ascending, int id) {
  return std::binary_search(ascending.begin(), ascending.end(), id);
}

/// Expects all pairs in reach to be found from both sides, and not all that there are.
void ExpectFindsAllInReach(const NearPairs& pairs, const GraphState& graph) {
  const int num_submaps = static_cast<int>(graph.submaps.size());
  const int num_nodes = static_cast<int>(graph.nodes.size());
  int num_in_reach = 0;
  int num_found = 0;
  for (int submap = 0; submap < num_submaps; ++submap) {
    const std::vector<int> nodes = pairs.NodesNear(SubmapId{submap}, graph);
    num_found += static_cast<int>(nodes.size());
    for (int node = 0; node < num_nodes; ++node) {
      const Pose2 submap_from_node = graph.SubmapFromNode(SubmapId{submap}, NodeId{node});
      const double distance =
          graph.submaps[submap].node_box.exteriorDistance(submap_from_node.translation);
      if (distance > kReach) continue;
      ++num_in_reach;
      EXPECT_TRUE(Holds(nodes, node)) << submap << " " << node;
      EXPECT_TRUE(Holds(pairs.SubmapsNear(NodeId{node}, graph), submap)) << submap << " " << node;
    }
  }
  EXPECT_GT(num_in_reach, num_nodes);
  EXPECT_LT(num_found, num_submaps * num_nodes / 4);
}

TEST(NearPairs, AreAllThatAreInReach) {
  Random random(1);
  for (int round = 0; round < 5; ++round) {
    const GraphState graph = AnyGraph(&random);
    ExpectFindsAllInReach(PairsOf(graph), graph);
  }
}

TEST(NearPairs, FollowTheGraphWhenTheyAreRenewed) {
  Random random(2);
  NearPairs pairs = PairsOf(AnyGraph(&random));
  GraphState moved = AnyGraph(&random);
  pairs.Renew(moved);
  ExpectFindsAllInReach(pairs, moved);
}

TEST(NearPairs, AreOfFinishedSubmapsOnly) {
  Random random(3);
  const GraphState graph = AnyGraph(&random);
  NearPairs pairs(1e6);
  for (int i = 0; i < static_cast<int>(graph.nodes.size()); ++i) pairs.AddNode(NodeId{i}, graph);
  pairs.AddFinishedSubmap(SubmapId{7}, graph);
  EXPECT_EQ(pairs.SubmapsNear(NodeId{0}, graph), std::vector<int>{7});
}

}  // namespace
}  // namespace loopscope
