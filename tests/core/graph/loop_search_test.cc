// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_search.h"

#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

constexpr int kDepth = 4;

ConstraintBuilderOptions Options(double sampling_ratio = 1.0) {
  ConstraintBuilderOptions options;
  options.sampling_ratio = sampling_ratio;
  options.fast_correlative_scan_matcher.branch_and_bound_depth = kDepth;
  options.loop_closure_translation_weight = 11.0;
  options.loop_closure_rotation_weight = 13.0;
  return options;
}

const Pose2 kTruth(2.0, 0.8, 0.4);

/// A pair whose guess is wrong, but right within the window.
LoopCandidate Candidate(int submap, int node, double min_score) {
  LoopCandidate candidate;
  candidate.submap = SubmapId{submap};
  candidate.node = NodeId{node};
  candidate.submap_from_node_guess = Pose2(2.35, 0.52, 0.3);
  candidate.linear_search_window = 0.5;
  candidate.angular_search_window = 0.2;
  candidate.min_score = min_score;
  return candidate;
}

class LoopSearchInARoom : public ::testing::Test {
 protected:
  LoopCandidate Search(const LoopCandidate& candidate,
                       const ConstraintBuilderOptions& options = ConstraintBuilderOptions()) const {
    return SearchLoop(candidate, *ScanOf(points_), room_.grid(), matcher_, options).candidate;
  }

  const SimulatedRoom room_;
  const PointCloud points_ = room_.ScanAt(kTruth);
  const BranchAndBoundMatcher matcher_{room_.grid(), kDepth};
};

TEST_F(LoopSearchInARoom, AcceptsWhatScoresEnoughAndRefinesIt) {
  const LoopCandidate result = Search(Candidate(3, 5, 0.5));
  EXPECT_EQ(result.verdict, Verdict::kAccepted);
  EXPECT_GT(result.score, 0.5);
  EXPECT_EQ(result.score, result.score_bound);
  EXPECT_THAT(result.submap_from_node_searched, PoseNear(kTruth, 0.05, 0.02));
  EXPECT_THAT(result.submap_from_node, PoseNear(kTruth, 0.02, 0.005));
  EXPECT_NE(result.submap_from_node, result.submap_from_node_searched);
  EXPECT_EQ(result.submap, SubmapId{3});
  EXPECT_EQ(result.node, NodeId{5});
}

TEST_F(LoopSearchInARoom, TellsTheBestThatItFoundBelowMinScore) {
  const LoopCandidate accepted = Search(Candidate(0, 0, 0.5));
  const LoopCandidate result = Search(Candidate(0, 0, accepted.score + 0.01));
  EXPECT_EQ(result.verdict, Verdict::kBelowMinScore);
  EXPECT_GT(result.score, kMinProbability);
  EXPECT_LE(result.score, accepted.score);
  EXPECT_GE(result.score_bound, accepted.score);
  EXPECT_LE(result.score_bound, accepted.score + 0.01);
  EXPECT_EQ(result.submap_from_node, result.submap_from_node_searched);
}

TEST_F(LoopSearchInARoom, FindsNothingOutsideOfTheWindow) {
  LoopCandidate candidate = Candidate(0, 0, 0.5);
  candidate.linear_search_window = 0.1;
  EXPECT_EQ(Search(candidate).verdict, Verdict::kBelowMinScore);
}

TEST_F(LoopSearchInARoom, SearchesTheWholeSubmapWhateverTheGuessIs) {
  LoopCandidate candidate = Candidate(0, 0, 0.5);
  candidate.whole_submap = true;
  candidate.submap_from_node_guess = Pose2(100.0, 100.0, -2.0);
  const LoopCandidate result = Search(candidate);
  EXPECT_EQ(result.verdict, Verdict::kAccepted);
  EXPECT_THAT(result.submap_from_node, PoseNear(kTruth, 0.02, 0.005));
}

TEST_F(LoopSearchInARoom, RefusesAWinnerThatHasARival) {
  ConstraintBuilderOptions options;
  options.ambiguity.min_distance = 0.2;
  options.ambiguity.max_relative_score = 0.9;
  const LoopCandidate alone = Search(Candidate(0, 0, 0.5), options);
  EXPECT_EQ(alone.verdict, Verdict::kAccepted);
  EXPECT_EQ(alone.rival_score, 0.0);
  options.ambiguity.max_relative_score = 0.5;
  const LoopCandidate with_rival = Search(Candidate(0, 0, 0.5), options);
  EXPECT_EQ(with_rival.verdict, Verdict::kAmbiguous);
  EXPECT_GT(with_rival.rival_score, 0.5 * with_rival.score);
  EXPECT_EQ(with_rival.score, alone.score);
}

TEST_F(LoopSearchInARoom, MakesAConstraintOfTheRefinedPose) {
  const LoopCandidate accepted = Search(Candidate(3, 5, 0.5));
  const Constraint constraint = ToConstraint(accepted, Options());
  EXPECT_EQ(constraint.submap, SubmapId{3});
  EXPECT_EQ(constraint.node, NodeId{5});
  EXPECT_EQ(constraint.submap_from_node, accepted.submap_from_node);
  EXPECT_EQ(constraint.translation_weight, 11.0);
  EXPECT_EQ(constraint.rotation_weight, 13.0);
  EXPECT_EQ(constraint.tag, Constraint::Tag::kInterSubmap);
}

TEST_F(LoopSearchInARoom, RefusesAWinnerAtTheBorderOnlyIfAsked) {
  LoopCandidate candidate = Candidate(0, 1, 0.3);
  candidate.submap_from_node_guess = kTruth * Pose2(0.4, 0.0, 0.0);
  candidate.linear_search_window = 0.25;
  ConstraintBuilderOptions options;
  const auto search = [&] { return Search(candidate, options); };
  EXPECT_EQ(search().verdict, Verdict::kAccepted);
  EXPECT_TRUE(IsAtBorder(search(), room_.grid().resolution()));
  options.ambiguity.refuse_at_border = true;
  EXPECT_EQ(search().verdict, Verdict::kAmbiguous);
  candidate.linear_search_window = 0.5;
  EXPECT_EQ(search().verdict, Verdict::kAccepted);
}

TEST(IsAtBorder, InTheOutermostCellsOnly) {
  constexpr double kResolution = 0.05;
  LoopCandidate found;
  const auto is_at_border = [&](double window, int num_cells) {
    found.linear_search_window = window;
    found.submap_from_node_searched = Pose2(
        found.submap_from_node_guess.translation - Eigen::Vector2d(0.0, kResolution * num_cells),
        0.0);
    return IsAtBorder(Rounded(found), kResolution);
  };
  for (const double guess : {0.0, 0.123457, -7.000001, 1234.567891}) {
    found.submap_from_node_guess = Pose2(guess, -guess, 0.3);
    for (const int num_cells : {1, 3, 7, 20, 22, 140}) {
      const double window = kResolution * num_cells;
      EXPECT_TRUE(is_at_border(window, num_cells)) << guess << " " << num_cells;
      EXPECT_FALSE(is_at_border(window, num_cells - 1)) << guess << " " << num_cells;
      EXPECT_TRUE(is_at_border(window - 0.02, num_cells)) << "the search takes whole cells";
      EXPECT_FALSE(is_at_border(window - 0.02, num_cells - 1));
    }
  }
  found.whole_submap = true;
  EXPECT_FALSE(is_at_border(1.0, 20));
}

/// Considers 3 submaps x 8 nodes, seen from different places, in an order of submap and node that
/// is not that of the result.
std::vector<LoopCandidate> SearchMany(const SimulatedRoom& room, int num_threads,
                                      double sampling_ratio) {
  LoopSearch search(Options(sampling_ratio), num_threads);
  for (int submap = 0; submap < 3; ++submap) search.AddSubmap(SubmapId{submap}, room.grid());
  Random random(4);
  for (int node = 7; node >= 0; --node) {
    const Pose2 truth(random.Uniform(1.0, 3.0), random.Uniform(0.0, 1.0), random.Uniform(-3, 3));
    const auto points = ScanOf(room.ScanAt(truth));
    for (int submap = 2; submap >= 0; --submap) {
      LoopCandidate candidate = Candidate(submap, node, 0.3 + 0.2 * submap);
      candidate.submap_from_node_guess = truth * Pose2(0.2, -0.1, 0.1);
      search.Consider(candidate, points);
    }
  }
  return search.Collect();
}

auto ResultOf(const LoopCandidate& c) {
  return std::tuple(c.submap.index, c.node.index, c.verdict, c.score, c.score_bound,
                    c.submap_from_node.x(), c.submap_from_node.y(), c.submap_from_node.rotation);
}

TEST_F(LoopSearchInARoom, FindsTheSameInTheSameOrderOnAnyNumberOfThreads) {
  const auto expected = SearchMany(room_, 1, 0.7);
  ASSERT_EQ(expected.size(), 24u);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(expected[i].submap.index, static_cast<int>(i / 8));
    EXPECT_EQ(expected[i].node.index, static_cast<int>(i % 8));
  }
  for (const int num_threads : {2, 4}) {
    const auto found = SearchMany(room_, num_threads, 0.7);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(ResultOf(found[i]), ResultOf(expected[i])) << num_threads << " threads, " << i;
    }
  }
}

TEST_F(LoopSearchInARoom, FindsTheSameInABatchAsAlone) {
  LoopSearch search(Options(), 2);
  search.AddSubmap(SubmapId{0}, room_.grid());
  constexpr int kNumPairs = 70;  // more than two batches
  for (int node = 0; node < kNumPairs; ++node) {
    search.Begin(Candidate(0, node, node % 2 == 0 ? 0.3 : 0.9), ScanOf(points_));
  }
  const std::vector<LoopCandidate> found = search.Collect();
  ASSERT_EQ(found.size(), static_cast<std::size_t>(kNumPairs));
  const LoopCandidate accepted = Search(Candidate(0, 0, 0.3));
  for (int node = 0; node < kNumPairs; ++node) {
    EXPECT_EQ(found[node].node, NodeId{node});
    const bool is_accepted = found[node].verdict == Verdict::kAccepted;
    EXPECT_EQ(is_accepted, node % 2 == 0);
    EXPECT_EQ(found[node].submap_from_node == accepted.submap_from_node, is_accepted);
  }
}

TEST_F(LoopSearchInARoom, GivesEveryCandidateOnce) {
  LoopSearch search(Options(), 2);
  search.AddSubmap(SubmapId{0}, room_.grid());
  const auto points = ScanOf(points_);
  search.Consider(Candidate(0, 1, 0.5), points);
  EXPECT_EQ(search.Collect().size(), 1u);
  EXPECT_TRUE(search.Collect().empty());
  search.Consider(Candidate(0, 2, 0.5), points);
  EXPECT_EQ(search.Collect().at(0).node, NodeId{2});
}

/// The nodes of a submap that were searched, of `num_nodes` that were considered.
std::vector<int> SampledNodes(double ratio, int num_nodes, const ProbabilityGrid& grid) {
  LoopSearch search(Options(ratio), 1);
  search.AddSubmap(SubmapId{0}, grid);
  const auto points = ScanOf({{1.0, 0.0}});
  for (int node = 0; node < num_nodes; ++node) search.Consider(Candidate(0, node, 0.5), points);
  std::vector<int> sampled;
  for (const LoopCandidate& candidate : search.Collect()) {
    if (candidate.verdict != Verdict::kNotSampled) sampled.push_back(candidate.node.index);
  }
  return sampled;
}

TEST_F(LoopSearchInARoom, SearchesExactlyTheShareThatSamplingRatioSays) {
  for (const double ratio : {0.0, 0.1, 0.3, 0.5, 0.9, 1.0}) {
    for (const int num_nodes : {1, 10, 50}) {
      // The nearest whole number from above: with any ratio the first pair is searched.
      const auto expected = static_cast<std::size_t>(std::ceil(ratio * num_nodes - 1e-9));
      EXPECT_EQ(SampledNodes(ratio, num_nodes, room_.grid()).size(), expected) << ratio;
    }
  }
  EXPECT_EQ(SampledNodes(0.3, 10, room_.grid()), (std::vector<int>{0, 3, 6}));
}

TEST_F(LoopSearchInARoom, SaysOfAPairThatWasNotSampledThatItWasNotSearched) {
  LoopSearch search(Options(0.0), 1);
  search.AddSubmap(SubmapId{0}, room_.grid());
  search.Consider(Candidate(0, 1, 0.5), ScanOf(points_));
  const LoopCandidate candidate = search.Collect().at(0);
  EXPECT_EQ(candidate.verdict, Verdict::kNotSampled);
  EXPECT_EQ(candidate.score, 0.0);
  EXPECT_EQ(candidate.score_bound, 0.0);
  EXPECT_EQ(candidate.submap_from_node_guess, Pose2());
}

}  // namespace
}  // namespace loopscope
