// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/pose_graph.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "tests/core/graph/return_to_a_room.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

TEST(PoseGraph, AcceptsALoopAndTellsWhenAndWhere) {
  ReturnToARoom run(Options());
  run.ComeTo(kFirst);
  const auto candidates = run.graph().CollectLoops(kStep + 3);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_EQ(candidates[0].verdict, Verdict::kAccepted);
  EXPECT_EQ(candidates[0].submap, SubmapId{0});
  EXPECT_EQ(candidates[0].node, NodeId{1});
  EXPECT_EQ(candidates[0].considered_step, kStep);
  EXPECT_EQ(candidates[0].applied_step, kStep + 3);
  EXPECT_EQ(candidates[0].min_score, 0.55);
  EXPECT_THAT(candidates[0].submap_from_node_guess, PoseNear(kDrift * kFirst, 1e-6, 1e-6));
  EXPECT_THAT(candidates[0].submap_from_node, PoseNear(kFirst, 0.02, 0.005));
}

TEST(PoseGraph, SearchesWiderWhereANodeMatchedNowhere) {
  PoseGraphOptions options = Options();
  options.constraint_builder.linear_search_window_per_meter = 0.01;
  options.constraint_builder.unmatched_node_way = 40.0;
  const auto window = [&](bool matched_nowhere) {
    ReturnToARoom run(options);
    run.graph().AddNode({kDrift * kFirst, std::nullopt, SubmapId{1}, 1,
                         ScanOf(SimulatedRoom().ScanAt(kFirst)), matched_nowhere},
                        kStep);
    return run.graph().CollectLoops(kStep).at(0).linear_search_window;
  };
  EXPECT_NEAR(window(true), window(false) + 0.4, 1e-5);
}

TEST(PoseGraph, TellsTheBestScoreBelowMinScore) {
  ReturnToARoom run(Options());
  run.AddNode(kDrift * kFirst, {{0.3, 0.1}, {0.5, -0.2}, {-0.4, 0.3}}, 1);
  const auto candidates = run.graph().CollectLoops(kStep);
  ASSERT_EQ(candidates.size(), 1u);
  EXPECT_EQ(candidates[0].verdict, Verdict::kBelowMinScore);
  EXPECT_GE(candidates[0].score, kMinProbability);
  EXPECT_LE(candidates[0].score, 0.55);
}

TEST(PoseGraph, LeavesAPairThatIsNotSampled) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.0;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  EXPECT_EQ(run.graph().CollectLoops(kStep).at(0).verdict, Verdict::kNotSampled);
}

TEST(PoseGraph, GivesSubmapsOfTheSamePlaceWithoutALoopASecondLook) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.0;
  options.constraint_builder.second_look.num_nodes = 2;
  options.constraint_builder.second_look.min_way = 0.5;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  run.graph().FinishSubmap(SubmapId{1}, SimulatedRoom().grid(), kStep + 1);
  for (const LoopCandidate& candidate : run.graph().CollectLoops(kStep + 1)) {
    EXPECT_EQ(candidate.verdict, Verdict::kNotSampled);
  }
  const auto candidates = run.graph().CollectLoops(kStep + 9);
  ASSERT_EQ(candidates.size(), 2u);  // each of the two nodes in the other submap
  EXPECT_EQ(candidates[0].verdict, Verdict::kAccepted);
  EXPECT_EQ(candidates[0].submap, SubmapId{0});
  EXPECT_EQ(candidates[0].node, NodeId{1});
  EXPECT_EQ(candidates[0].considered_step, kStep + 9);
  EXPECT_THAT(candidates[0].submap_from_node, PoseNear(kFirst, 0.02, 0.005));
  EXPECT_TRUE(run.graph().CollectLoops(kStep + 20).empty()) << "a loop ties them";
}

TEST(PoseGraph, TakesALastLookForLessThanItsScoreInTheLeastWindow) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.0;
  options.constraint_builder.linear_search_window_per_meter = 0.1;
  options.constraint_builder.second_look.min_way = 0.5;
  options.constraint_builder.last_look = {2, 0.9};
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  run.graph().FinishSubmap(SubmapId{1}, SimulatedRoom().grid(), kStep + 1);
  run.graph().CollectLoops(kStep + 1);
  const auto candidates = run.graph().LookLast(kStep + 2);
  ASSERT_EQ(candidates.size(), 2u);  // each of the two nodes in the other submap
  EXPECT_EQ(candidates[0].verdict, Verdict::kAccepted);
  EXPECT_EQ(candidates[0].node, NodeId{1});
  EXPECT_EQ(candidates[0].applied_step, kStep + 2);
  EXPECT_NEAR(candidates[0].min_score, 0.9 * 0.55, 1e-12);
  EXPECT_EQ(candidates[0].linear_search_window, 0.6);
  EXPECT_TRUE(run.graph().LookLast(kStep + 3).empty()) << "a loop ties them";
}

/// What a last look makes of a node half of whose points lie beyond the submap.
LoopCandidate LastLookFromTheEdge(double min_known_share) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.0;
  options.constraint_builder.second_look.min_way = 0.5;
  options.constraint_builder.last_look = {2, 0.9, min_known_share};
  ReturnToARoom run(options);
  PointCloud points = SimulatedRoom().ScanAt(kFirst);
  const std::size_t num_points = points.size();
  for (std::size_t i = 0; i < num_points; ++i) points.emplace_back(50.0 + 0.1 * i, 40.0);
  run.AddNode(kFirst, points, 1);
  run.graph().FinishSubmap(SubmapId{1}, SimulatedRoom().grid(), kStep);
  run.graph().CollectLoops(kStep);
  return run.graph().LookLast(kStep + 1).at(0);
}

TEST(PoseGraph, AsksLessOfALastLookFromTheEdgeOfWhatASubmapKnows) {
  const LoopCandidate found = LastLookFromTheEdge(0.35);
  EXPECT_EQ(found.verdict, Verdict::kAccepted);
  EXPECT_NEAR(found.min_score, 0.5 * 0.9 * 0.55 + 0.5 * kMinProbability, 0.01);
  EXPECT_GT(found.score, found.min_score);
  const LoopCandidate refused = LastLookFromTheEdge(1.0);
  EXPECT_EQ(refused.verdict, Verdict::kBelowMinScore);
  EXPECT_NEAR(refused.min_score, 0.9 * 0.55, 1e-12);
}

TEST(PoseGraph, DoesNotConsiderWhatIsTooFarOrBlindOrLiesInTheSubmap) {
  ReturnToARoom run(Options());
  run.AddNode(Pose2(4.1, 0.5, 0.0), {{1.0, 0.0}}, 1);  // 3.1 m from the only node of submap 0
  run.AddNode(Pose2(2.0, 0.5, 0.0), {}, 1);
  run.AddNode(Pose2(2.0, 0.5, 0.0), {{1.0, 0.0}}, 0);
  EXPECT_TRUE(run.graph().CollectLoops(kStep).empty());
}

TEST(PoseGraph, ConsidersNothingIfItNeverOptimizes) {
  PoseGraphOptions options = Options();
  options.optimize_every_n_nodes = 0;
  options.constraint_builder.second_look.num_nodes = 2;
  options.constraint_builder.second_look.min_way = 0.5;
  options.constraint_builder.last_look.num_nodes = 2;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  EXPECT_TRUE(run.graph().CollectLoops(kStep).empty());
  EXPECT_FALSE(run.graph().OptimizationIsDue());
  run.graph().FinishSubmap(SubmapId{1}, SimulatedRoom().grid(), kStep + 1);
  EXPECT_TRUE(run.graph().CollectLoops(kStep + 1).empty());
  EXPECT_TRUE(run.graph().CollectLoops(kStep + 2).empty());
  EXPECT_TRUE(run.graph().LookLast(kStep + 3).empty());
}

TEST(PoseGraph, ConsidersTheNodesThatWereThereWhenASubmapIsFinished) {
  ReturnToARoom run(Options());
  run.ComeTo(kFirst);
  run.ComeTo(kSecond);
  run.graph().CollectLoops(kStep);
  run.graph().FinishSubmap(SubmapId{1}, SimulatedRoom().grid(), kStep + 1);
  const auto candidates = run.graph().CollectLoops(kStep + 1);
  ASSERT_EQ(candidates.size(), 1u);  // nodes 1 and 2 lie in it
  EXPECT_EQ(candidates[0].submap, SubmapId{1});
  EXPECT_EQ(candidates[0].node, NodeId{0});
  EXPECT_EQ(candidates[0].considered_step, kStep + 1);
}

TEST(PoseGraph, BelievesNoLoopThatStandsAlone) {
  PoseGraphOptions options = Options();
  options.constraint_builder.consistency.min_num_supporters = 1;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  const LoopCandidate alone = run.graph().CollectLoops(kStep).at(0);
  EXPECT_EQ(alone.verdict, Verdict::kInconsistent);
  EXPECT_EQ(alone.num_supporters, 0);
  EXPECT_GT(alone.score, alone.min_score);
}

TEST(PoseGraph, BelievesLoopsThatAgree) {
  PoseGraphOptions options = Options();
  options.constraint_builder.consistency.min_num_supporters = 1;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  run.ComeTo(kSecond);
  for (const LoopCandidate& candidate : run.graph().CollectLoops(kStep)) {
    EXPECT_EQ(candidate.verdict, Verdict::kAccepted);
    EXPECT_EQ(candidate.num_supporters, 1);
  }
  run.ComeTo(Pose2(2.6, 1.0, 0.6));
  EXPECT_EQ(run.graph().CollectLoops(kStep).at(0).num_supporters, 2);  // earlier ones count
}

/// One of three nodes on the way through the room is searched, by sampling.
std::vector<LoopCandidate> LoopsOfThreeNodesWithOneSampled(int num_checked_neighbors) {
  PoseGraphOptions options = Options();
  options.constraint_builder.sampling_ratio = 0.3;
  options.constraint_builder.consistency.min_num_supporters = 1;
  options.constraint_builder.consistency.num_checked_neighbors = num_checked_neighbors;
  ReturnToARoom run(options);
  run.ComeTo(kFirst);
  run.ComeTo(kSecond);
  run.ComeTo(Pose2(2.6, 1.0, 0.6));
  return run.graph().CollectLoops(kStep);
}

TEST(PoseGraph, SearchesNeighborsOfALoopThatStandsAlone) {
  int num_accepted = 0;
  for (const LoopCandidate& candidate : LoopsOfThreeNodesWithOneSampled(0)) {
    EXPECT_NE(candidate.verdict, Verdict::kAccepted);
  }
  for (const LoopCandidate& candidate : LoopsOfThreeNodesWithOneSampled(2)) {
    if (candidate.verdict != Verdict::kAccepted) continue;
    EXPECT_GE(candidate.num_supporters, 1);
    ++num_accepted;
  }
  EXPECT_EQ(num_accepted, 3);
}

TEST(PoseGraph, SamplesPairsWithAWideWindowLess) {
  const auto num_sampled = [](double full_sampling_search_window) {
    PoseGraphOptions options = Options();
    options.constraint_builder.full_sampling_search_window = full_sampling_search_window;
    ReturnToARoom run(options);
    for (int i = 0; i < 8; ++i) run.ComeTo(kFirst);
    int count = 0;
    for (const LoopCandidate& candidate : run.graph().CollectLoops(kStep)) {
      if (candidate.verdict != Verdict::kNotSampled) ++count;
    }
    return count;
  };
  const double window =
      Options().constraint_builder.fast_correlative_scan_matcher.linear_search_window;
  EXPECT_EQ(num_sampled(0.0), 8);
  EXPECT_EQ(num_sampled(window), 8);
  EXPECT_EQ(num_sampled(0.25 * window), 2);
}

/// Of loops of 40 nodes that drift by nothing, searched after an optimization, and before.
std::vector<double> WindowsAfterTrueLoops(const PoseGraphOptions& options) {
  ReturnToARoom run(options);
  const auto come = [&] { run.AddNode(kFirst, SimulatedRoom().ScanAt(kFirst), 1); };
  for (int i = 0; i < 40; ++i) come();
  run.graph().CollectLoops(kStep);
  run.graph().Optimize();
  for (int i = 0; i < 8; ++i) come();
  std::vector<double> windows;
  for (const LoopCandidate& loop : run.graph().CollectLoops(kStep)) {
    windows.push_back(loop.linear_search_window);
  }
  return windows;
}

TEST(PoseGraph, SearchesAsFarAsLoopsWereOff) {
  const double window =
      Options().constraint_builder.fast_correlative_scan_matcher.linear_search_window;
  PoseGraphOptions options = Options();
  EXPECT_THAT(WindowsAfterTrueLoops(options), ::testing::Each(window)) << "off";
  options.constraint_builder.measured_drift.min_window_share = 0.5;
  const std::vector<double> windows = WindowsAfterTrueLoops(options);
  EXPECT_EQ(std::count(windows.begin(), windows.end(), 0.5 * window), 7);
  EXPECT_EQ(std::count(windows.begin(), windows.end(), window), 1) << "to notice if drift grows";
}

TEST(PoseGraph, SamplesNodesThatHardlyMovedLess) {
  PoseGraphOptions options = Options();
  options.constraint_builder.full_sampling_gap = 0.5;
  ReturnToARoom run(options);
  for (int i = 0; i < 9; ++i) run.ComeTo(kFirst);  // the first of them has come some way
  int num_searched = 0;
  for (const LoopCandidate& candidate : run.graph().CollectLoops(kStep)) {
    if (candidate.verdict != Verdict::kNotSampled) ++num_searched;
  }
  EXPECT_EQ(num_searched, 1 + 2);
}

TEST(PoseGraph, PlacesWhatComesLaterByTheNewestSubmap) {
  ReturnToARoom run(Options());
  run.ComeTo(kFirst);
  run.graph().CollectLoops(kStep);
  run.graph().Optimize();
  run.ComeTo(kSecond);
  const LoopCandidate candidate = run.graph().CollectLoops(kStep).at(0);
  EXPECT_THAT(candidate.submap_from_node_guess, PoseNear(kSecond, 0.05, 0.02));
}

}  // namespace
}  // namespace loopscope
