// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/search_trace.h"

#include <algorithm>
#include <map>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/exhaustive_search.h"
#include "tests/support/random_search.h"

// What must hold in the trace of every search by branch and bound.
namespace loopscope {
namespace {

constexpr int kNumWorlds = 60;
constexpr double kRounding = 1e-12;

/// A search that finds the optimum for an even seed, and nothing for an odd one.
struct TracedSearch {
  explicit TracedSearch(int seed) : search(seed) {
    outcome = search.Run(0.0, &trace);
    if (seed % 2 == 1) outcome = search.Run(outcome.winner->score + 0.01, &trace);
  }

  /// Calls `visit(offset)` for the poses of the block of `node` in the window.
  template <typename Visitor>
  void ForEachOffset(const SearchNode& node, const Visitor& visit) const {
    const int end = trace.window.num_linear_steps + 1;
    const int side = 1 << node.height;
    for (int x = node.offset.x; x < std::min(node.offset.x + side, end); ++x) {
      for (int y = node.offset.y; y < std::min(node.offset.y + side, end); ++y) {
        visit(CellIndex{x, y});
      }
    }
  }

  double PlainScoreAt(CellIndex offset, int angle_index) const {
    return PlainScore(search.world().points_in_scan, PlainPose(trace.window, offset, angle_index),
                      search.world().grid);
  }

  RandomSearch search;
  SearchTrace trace;
  SearchOutcome outcome;
};

/// Runs `check` on the searches of all worlds.
template <typename Check>
void ForEachSearch(const Check& check) {
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    check(TracedSearch(seed));
  }
}

TEST(SearchTrace, HasNoChildWhoseBoundIsAboveItsParents) {
  ForEachSearch([](const TracedSearch& searched) {
    for (const SearchNode& node : searched.trace.nodes) {
      if (node.parent < 0) continue;
      EXPECT_LE(node.bound, searched.trace.nodes[node.parent].bound);
    }
  });
}

TEST(SearchTrace, HasNoPrunedBoundAboveTheScoreOfTheWinner) {
  ForEachSearch([](const TracedSearch& searched) {
    if (!searched.outcome.winner) return;
    for (const SearchNode& node : searched.trace.nodes) {
      if (node.fate == SearchFate::kPruned) {
        EXPECT_LE(node.bound, searched.outcome.winner->score);
      }
    }
  });
}

TEST(SearchTrace, BoundsThePlainScoreOfEveryPoseOfABlock) {
  for (int seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const TracedSearch searched(seed);
    std::map<std::vector<int>, double> score_of;
    ForEachPose(searched.trace.window, [&](CellIndex offset, int angle) {
      score_of[{offset.x, offset.y, angle}] = searched.PlainScoreAt(offset, angle);
    });
    for (const SearchNode& node : searched.trace.nodes) {
      double best = 0.0;
      searched.ForEachOffset(node, [&](CellIndex offset) {
        best = std::max(best, score_of.at({offset.x, offset.y, node.angle_index}));
      });
      EXPECT_GE(node.bound, best - kRounding) << "height " << node.height;
    }
  }
}

TEST(SearchTrace, GivesEveryLeafThePlainScoreOfItsPose) {
  int num_leaves = 0;
  ForEachSearch([&](const TracedSearch& searched) {
    for (const SearchNode& node : searched.trace.nodes) {
      if (node.height > 0) continue;
      EXPECT_NEAR(node.bound, searched.PlainScoreAt(node.offset, node.angle_index), kRounding);
      ++num_leaves;
    }
  });
  EXPECT_GT(num_leaves, 1000);
}

TEST(SearchTrace, TilesTheWindowWithItsStartNodes) {
  ForEachSearch([](const TracedSearch& searched) {
    std::map<std::vector<int>, int> times_covered;
    for (const SearchNode& node : searched.trace.nodes) {
      if (node.parent >= 0) continue;
      searched.ForEachOffset(node, [&](CellIndex offset) {
        ++times_covered[{offset.x, offset.y, node.angle_index}];
      });
    }
    std::size_t num_poses = 0;
    ForEachPose(searched.trace.window, [&](CellIndex offset, int angle) {
      ++num_poses;
      EXPECT_EQ((times_covered[{offset.x, offset.y, angle}]), 1);
    });
    EXPECT_EQ(times_covered.size(), num_poses);
  });
}

TEST(SearchTrace, TilesEveryExpandedBlockWithItsChildren) {
  ForEachSearch([](const TracedSearch& searched) {
    const std::vector<SearchNode>& nodes = searched.trace.nodes;
    std::vector<std::vector<CellIndex>> covered(nodes.size());
    for (const SearchNode& node : nodes) {
      if (node.parent < 0) continue;
      const SearchNode& parent = nodes[node.parent];
      EXPECT_LT(node.height, parent.height);
      EXPECT_EQ(node.angle_index, parent.angle_index);
      searched.ForEachOffset(node,
                             [&](CellIndex offset) { covered[node.parent].push_back(offset); });
    }
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      std::vector<CellIndex> expected;
      if (nodes[i].fate == SearchFate::kExpanded) {
        searched.ForEachOffset(nodes[i], [&](CellIndex offset) { expected.push_back(offset); });
      }
      EXPECT_TRUE(std::is_permutation(covered[i].begin(), covered[i].end(), expected.begin(),
                                      expected.end()))
          << "node " << i;
    }
  });
}

TEST(SearchTrace, VisitsEveryNodeOnceAndAfterItsParent) {
  ForEachSearch([](const TracedSearch& searched) {
    const SearchTrace& trace = searched.trace;
    ASSERT_EQ(trace.visits.size(), trace.nodes.size());
    std::vector<bool> visited(trace.nodes.size(), false);
    for (const int visit : trace.visits) {
      EXPECT_FALSE(visited[visit]);
      visited[visit] = true;
      const int parent = trace.nodes[visit].parent;
      if (parent >= 0) {
        EXPECT_TRUE(visited[parent]);
      }
    }
  });
}

TEST(SearchTrace, VisitsTheChildrenOfANodeInTheOrderOfTheirBounds) {
  ForEachSearch([](const TracedSearch& searched) {
    std::map<int, double> last_bound_of_parent;
    for (const int visit : searched.trace.visits) {
      const SearchNode& node = searched.trace.nodes[visit];
      const auto last = last_bound_of_parent.find(node.parent);
      if (last != last_bound_of_parent.end()) {
        EXPECT_LE(node.bound, last->second);
      }
      last_bound_of_parent[node.parent] = node.bound;
    }
  });
}

TEST(SearchTrace, GoesDownBeforeItGoesOn) {
  // Depth first: between a node and its next sibling stand its descendants only.
  ForEachSearch([](const TracedSearch& searched) {
    std::vector<int> path;
    for (const int visit : searched.trace.visits) {
      const int parent = searched.trace.nodes[visit].parent;
      while (!path.empty() && path.back() != parent) path.pop_back();
      EXPECT_EQ(path.empty() ? -1 : path.back(), parent);
      path.push_back(visit);
    }
  });
}

TEST(SearchTrace, DecidesFatesByBoundsAndTheBestScoreSoFar) {
  ForEachSearch([](const TracedSearch& searched) {
    double best = searched.trace.nodes[searched.trace.visits.front()].best_before;
    for (const int visit : searched.trace.visits) {
      const SearchNode& node = searched.trace.nodes[visit];
      EXPECT_EQ(node.best_before, best);
      const SearchFate fate = node.bound <= best ? SearchFate::kPruned
                              : node.height > 0  ? SearchFate::kExpanded
                                                 : SearchFate::kImproved;
      EXPECT_EQ(node.fate, fate);
      if (node.fate == SearchFate::kImproved) best = node.bound;
    }
  });
}

TEST(SearchTrace, BeginsWithMinScoreAsTheBest) {
  SearchTrace trace;
  RandomSearch(3).Run(0.37, &trace);
  EXPECT_EQ(trace.nodes[trace.visits.front()].best_before, 0.37);
}

TEST(SearchTrace, NamesTheLastLeafThatImprovedAsTheWinner) {
  ForEachSearch([](const TracedSearch& searched) {
    const SearchTrace& trace = searched.trace;
    int last_improved = -1;
    for (const int visit : trace.visits) {
      if (trace.nodes[visit].fate == SearchFate::kImproved) last_improved = visit;
    }
    EXPECT_EQ(trace.winner, last_improved);
    ASSERT_EQ(trace.winner >= 0, searched.outcome.winner.has_value());
    if (trace.winner < 0) return;
    const SearchNode& winner = trace.nodes[trace.winner];
    EXPECT_EQ(searched.outcome.winner->score, winner.bound);
    const Pose2 pose = PlainPose(trace.window, winner.offset, winner.angle_index);
    EXPECT_NEAR((searched.outcome.winner->submap_from_scan.translation - pose.translation).norm(),
                0.0, 1e-12);
  });
}

TEST(SearchTrace, IsOverwrittenByTheNextSearch) {
  SearchTrace trace;
  RandomSearch(4).Run(0.0, &trace);
  RandomSearch(5).Run(0.0, &trace);
  SearchTrace fresh;
  RandomSearch(5).Run(0.0, &fresh);
  EXPECT_EQ(trace.nodes.size(), fresh.nodes.size());
  EXPECT_EQ(trace.visits, fresh.visits);
  EXPECT_EQ(trace.winner, fresh.winner);
}

}  // namespace
}  // namespace loopscope
