// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/travel_graph.h"

#include <algorithm>
#include <limits>

#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

/// Submaps 0, 1, 2, ... in a row, so far one after the other.
TravelGraph Row(const std::vector<double>& ways) {
  TravelGraph graph;
  graph.AddSubmap(0.0);
  for (const double way : ways) graph.AddSubmap(way);
  return graph;
}

TEST(TravelGraph, AddsUpTheWayAlongTheRobotsPath) {
  const TravelGraph graph = Row({1.0, 2.0, 4.0});
  EXPECT_EQ(graph.WaysFrom(SubmapId{0}), (std::vector<double>{0.0, 1.0, 3.0, 7.0}));
  EXPECT_EQ(graph.WaysFrom(SubmapId{2}), (std::vector<double>{3.0, 2.0, 0.0, 4.0}));
}

TEST(TravelGraph, TakesALoopAsAShortCutBothWays) {
  TravelGraph graph = Row({1.0, 2.0, 4.0, 8.0});
  graph.AddLoop(SubmapId{0}, SubmapId{4});
  EXPECT_EQ(graph.WaysFrom(SubmapId{0}), (std::vector<double>{0.0, 1.0, 3.0, 7.0, 0.0}));
  EXPECT_EQ(graph.WaysFrom(SubmapId{4}), (std::vector<double>{0.0, 1.0, 3.0, 7.0, 0.0}));
  EXPECT_EQ(graph.WaysFrom(SubmapId{3}), (std::vector<double>{7.0, 6.0, 4.0, 0.0, 7.0}));
}

TEST(TravelGraph, IsAsBeforeWhenALoopIsAddedAgain) {
  TravelGraph graph = Row({1.0, 2.0, 4.0});
  graph.AddLoop(SubmapId{0}, SubmapId{3});
  const std::vector<double> ways = graph.WaysFrom(SubmapId{2});
  graph.AddLoop(SubmapId{0}, SubmapId{3});
  graph.AddLoop(SubmapId{3}, SubmapId{0});
  graph.AddLoop(SubmapId{2}, SubmapId{2});
  EXPECT_EQ(graph.WaysFrom(SubmapId{2}), ways);
}

TEST(TravelGraph, ForgetsItsLastAnswerWhenItGrows) {
  TravelGraph graph = Row({1.0, 2.0});
  EXPECT_EQ(graph.WaysFrom(SubmapId{0}), (std::vector<double>{0.0, 1.0, 3.0}));
  graph.AddSubmap(4.0);
  EXPECT_EQ(graph.WaysFrom(SubmapId{0}), (std::vector<double>{0.0, 1.0, 3.0, 7.0}));
  graph.AddLoop(SubmapId{0}, SubmapId{2});
  EXPECT_EQ(graph.WaysFrom(SubmapId{0}), (std::vector<double>{0.0, 1.0, 0.0, 4.0}));
}

/// All shortest ways by Floyd and Warshall's algorithm.
std::vector<std::vector<double>> AllWays(const std::vector<double>& ways,
                                         const std::vector<std::pair<int, int>>& loops) {
  const int size = static_cast<int>(ways.size()) + 1;
  std::vector<std::vector<double>> all(
      size, std::vector<double>(size, std::numeric_limits<double>::infinity()));
  const auto connect = [&](int a, int b, double way) {
    all[a][b] = all[b][a] = std::min(all[a][b], way);
  };
  for (int i = 0; i < size; ++i) all[i][i] = 0.0;
  for (int i = 0; i + 1 < size; ++i) connect(i, i + 1, ways[i]);
  for (const auto& [a, b] : loops) connect(a, b, 0.0);
  for (int k = 0; k < size; ++k) {
    for (int i = 0; i < size; ++i) {
      for (int j = 0; j < size; ++j) all[i][j] = std::min(all[i][j], all[i][k] + all[k][j]);
    }
  }
  return all;
}

TEST(TravelGraph, FindsTheShortestWays) {
  Random random(5);
  for (int round = 0; round < 20; ++round) {
    std::vector<double> ways;
    for (int i = 0; i < 15; ++i) ways.push_back(random.Uniform(0.0, 5.0));
    TravelGraph graph = Row(ways);
    std::vector<std::pair<int, int>> loops;
    for (int i = 0; i < round / 3; ++i) {
      loops.emplace_back(random.Below(16), random.Below(16));
      graph.AddLoop(SubmapId{loops.back().first}, SubmapId{loops.back().second});
    }
    const auto expected = AllWays(ways, loops);
    for (int from = 0; from < 16; ++from) {
      const std::vector<double> found = graph.WaysFrom(SubmapId{from});
      for (int to = 0; to < 16; ++to) EXPECT_NEAR(found[to], expected[from][to], 1e-12);
    }
  }
}

}  // namespace
}  // namespace loopscope
