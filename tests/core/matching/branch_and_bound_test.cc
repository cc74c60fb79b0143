// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/branch_and_bound.h"

#include <cmath>
#include <functional>

#include <gmock/gmock.h>

#include "core/matching/search_lattice.h"
#include "core/sensor/voxel_filter.h"
#include "tests/support/exhaustive_search.h"
#include "tests/support/plain_branch_and_bound.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_search.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

constexpr int kNumWorlds = 60;
constexpr double kRounding = 1e-12;  // sums of bytes are divided in another order

double PlainScore(const RandomWorld& world, const Pose2& submap_from_scan) {
  return PlainScore(world.points_in_scan, submap_from_scan, world.grid);
}

SearchResult ExhaustiveSearch(const RandomWorld& world, const SearchWindow& window) {
  return ExhaustiveSearch(world.points_in_scan, world.grid, window);
}

TEST(BranchAndBound, FindsTheOptimumOfExhaustiveSearch) {
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    SearchTrace trace;
    const SearchOutcome outcome = search.Run(0.0, &trace);
    const SearchResult best = ExhaustiveSearch(search.world(), trace.window);
    ASSERT_TRUE(outcome.winner);
    EXPECT_NEAR(outcome.winner->score, best.score, kRounding);
    EXPECT_NEAR(PlainScore(search.world(), outcome.winner->submap_from_scan), best.score,
                kRounding);
  }
}

TEST(BranchAndBound, ReportsTheWinnerAsBestFoundAndAsTheBound) {
  const SearchOutcome outcome = RandomSearch(1).Run(0.0, nullptr);
  EXPECT_EQ(outcome.best_found.submap_from_scan, outcome.winner->submap_from_scan);
  EXPECT_EQ(outcome.best_found.score, outcome.winner->score);
  EXPECT_EQ(outcome.score_bound, outcome.winner->score);
}

TEST(BranchAndBound, FindsTheSameScoreWithAnyNumberOfGrids) {
  for (int seed = 0; seed < 20; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    const double score = search.RunWithDepth(1, 0.0, nullptr).winner->score;
    for (int depth = 2; depth <= 8; ++depth) {
      EXPECT_EQ(search.RunWithDepth(depth, 0.0, nullptr).winner->score, score);
    }
  }
}

TEST(BranchAndBound, IsTheSameWithAndWithoutATrace) {
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    for (const double min_score : {0.0, 0.8}) {
      SearchTrace trace;
      const SearchOutcome with = search.Run(min_score, &trace);
      const SearchOutcome without = search.Run(min_score, nullptr);
      ASSERT_EQ(with.winner.has_value(), without.winner.has_value());
      EXPECT_EQ(with.best_found.submap_from_scan, without.best_found.submap_from_scan);
      EXPECT_EQ(with.best_found.score, without.best_found.score);
      EXPECT_EQ(with.score_bound, without.score_bound);
    }
  }
}

/// Windows of many squares, and many angles that are bounded together: with sectors of one size,
/// and with larger ones that are split.
TEST(BranchAndBound, IsTheSameInWideWindowsWithAndWithoutATrace) {
  for (int seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const double linear_window = seed % 2 == 0 ? 2.0 : 3.3;
    Random random(seed);
    const RandomWorld world = MakeRandomWorld(&random);
    const BranchAndBoundMatcher matcher(world.grid, 7);
    const auto anywhere = [&](double window) { return random.Uniform(-window, window); };
    const Pose2 guess =
        world.submap_from_scan *
        Pose2(anywhere(0.7 * linear_window), anywhere(0.7 * linear_window), anywhere(0.95));
    double best_score = 0.0;
    for (const double min_score : {0.0, 0.4, 0.6, 0.8, 0.89}) {
      SearchTrace trace;
      const auto with =
          matcher.Search(world.points_in_scan, guess, linear_window, 1.0, min_score, &trace);
      const auto without =
          matcher.Search(world.points_in_scan, guess, linear_window, 1.0, min_score);
      ASSERT_EQ(with.winner.has_value(), without.winner.has_value());
      EXPECT_EQ(with.best_found.submap_from_scan, without.best_found.submap_from_scan);
      EXPECT_EQ(with.best_found.score, without.best_found.score);
      EXPECT_EQ(with.score_bound, without.score_bound);
      if (min_score == 0.0) best_score = without.best_found.score;
      EXPECT_EQ(without.winner.has_value(), best_score > min_score);
    }
    const PlainPrecomputedGrids plain_grids(world.grid, 7);
    const SearchWindow window =
        MakeSearchWindow(world.points_in_scan, guess, linear_window, 1.0, 0.05);
    EXPECT_EQ(PlainBranchAndBound(plain_grids, window, world.points_in_scan, 0.0)->score,
              best_score);
  }
}

TEST(BranchAndBound, FindsNothingThatDoesNotBeatMinScore) {
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    const SearchResult best = *search.Run(0.0, nullptr).winner;
    EXPECT_FALSE(search.Run(best.score, nullptr).winner);
    const SearchOutcome just_enough = search.Run(best.score - 1e-9, nullptr);
    ASSERT_TRUE(just_enough.winner);
    EXPECT_EQ(just_enough.winner->score, best.score);
  }
}

TEST(BranchAndBound, BoundsTheScoreWhenItFindsNothing) {
  int num_loose = 0;
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    const double optimum = search.Run(0.0, nullptr).winner->score;
    const double min_score = optimum + 0.05;
    SearchTrace trace;
    const SearchOutcome outcome = search.Run(min_score, &trace);
    EXPECT_FALSE(outcome.winner);
    EXPECT_EQ(trace.winner, -1);
    EXPECT_GE(outcome.score_bound, optimum);
    EXPECT_LE(outcome.score_bound, min_score);
    EXPECT_LE(outcome.best_found.score, optimum);
    EXPECT_NEAR(PlainScore(search.world(), outcome.best_found.submap_from_scan),
                outcome.best_found.score, kRounding);
    if (outcome.score_bound > optimum) ++num_loose;
  }
  EXPECT_GT(num_loose, 0);  // else these worlds would not tell a bound from the optimum
}

TEST(BranchAndBound, LooksNoFartherThanTheWindow) {
  for (int seed = 0; seed < kNumWorlds; ++seed) {
    SCOPED_TRACE(seed);
    SearchTrace trace;
    const SearchOutcome outcome = RandomSearch(seed).Run(0.0, &trace);
    const Eigen::Vector2d shift = outcome.winner->submap_from_scan.translation -
                                  trace.window.submap_from_scan_guess.translation;
    EXPECT_LE(shift.cwiseAbs().maxCoeff(), 0.05 * trace.window.num_linear_steps + 1e-9);
  }
}

TEST(SearchWholeSubmap, FindsThePoseOfAScanWithoutAGuess) {
  const SimulatedRoom room;
  const BranchAndBoundMatcher matcher(room.grid(), 6);
  for (const Pose2& truth : {Pose2(0.5, -0.6, 0.3), Pose2(3.3, 1.8, 3.1), Pose2(4.4, -1.0, -2.0)}) {
    const PointCloud points = VoxelFilter(room.ScanAt(truth), 0.25);
    const SearchOutcome outcome = matcher.SearchWholeSubmap(points, 0.5);
    ASSERT_TRUE(outcome.winner);
    EXPECT_THAT(outcome.winner->submap_from_scan, PoseNear(truth, 0.06, 0.03));
  }
}

TEST(SearchWholeSubmap, ScoresFarFewerNodesThanThereArePoses) {
  const SimulatedRoom room;
  SearchTrace trace;
  BranchAndBoundMatcher(room.grid(), 6)
      .SearchWholeSubmap(VoxelFilter(room.ScanAt(Pose2(0.5, -0.6, 0.3)), 0.25), 0.5, &trace);
  std::size_t num_poses = 0;
  ForEachPose(trace.window, [&](CellIndex, int) { ++num_poses; });
  EXPECT_GT(num_poses, 1000000u);
  EXPECT_LT(20 * trace.nodes.size(), num_poses);
}

TEST(SearchWholeSubmap, CoversAllKnownCellsAndAllAngles) {
  Random random(1);
  for (int i = 0; i < 10; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    SearchTrace trace;
    BranchAndBoundMatcher(world.grid, 6).SearchWholeSubmap(world.points_in_scan, 0.9, &trace);
    const SearchWindow& window = trace.window;
    const CellBox known = world.grid.box();
    const Eigen::Vector2d reach = Eigen::Vector2d::Constant(0.05 * window.num_linear_steps + 1e-9);
    const Eigen::Vector2d guess = window.submap_from_scan_guess.translation;
    const Eigen::Vector2d low = CenterOf(known.min, 0.05);
    const Eigen::Vector2d high =
        CenterOf({known.min.x + known.width - 1, known.min.y + known.height - 1}, 0.05);
    EXPECT_TRUE(((low - guess).cwiseAbs().array() <= reach.array()).all());
    EXPECT_TRUE(((high - guess).cwiseAbs().array() <= reach.array()).all());
    EXPECT_GE(window.num_angular_steps * window.angular_step, M_PI);
  }
}

TEST(SearchWholeSubmap, FindsTheOptimumOfExhaustiveSearch) {
  Random random(2);
  for (int i = 0; i < 2; ++i) {
    RandomWorld world = MakeRandomWorld(&random);
    world.points_in_scan.resize(6);
    SearchTrace trace;
    const SearchOutcome outcome =
        BranchAndBoundMatcher(world.grid, 4).SearchWholeSubmap(world.points_in_scan, 0.0, &trace);
    EXPECT_NEAR(outcome.winner->score, ExhaustiveSearch(world, trace.window).score, kRounding);
  }
}

/// The best score in the window farther than `min_distance` [m] from `winner`, by trying all
/// (Algorithm 1).
double BestScoreElsewhere(const RandomWorld& world, const SearchWindow& window, const Pose2& winner,
                          double min_distance) {
  double best = 0.0;
  ForEachPose(window, [&](CellIndex offset, int angle_index) {
    const Pose2 pose = PlainPose(window, offset, angle_index);
    if ((pose.translation - winner.translation).norm() <= min_distance) return;
    best = std::max(best, PlainScore(world, pose));
  });
  return best;
}

/// Of rivals that must score a little less than the best pose elsewhere, that is the only one; of
/// those that must score a little more, there is none. `search_with` is given a min_score that
/// leaves out all but the winner, and the criterion.
void ExpectTheOnlyRival(
    const RandomWorld& world, const SearchWindow& window, const Pose2& winner, double min_distance,
    const std::function<SearchOutcome(double min_score, const RivalCriterion&)>& search_with) {
  const double best = BestScoreElsewhere(world, window, winner, min_distance);
  const double min_score = PlainScore(world, winner) - 1e-6;
  const double share = best / PlainScore(world, winner);
  const SearchOutcome with = search_with(min_score, {min_distance, share - 1e-9});
  EXPECT_EQ(with.winner->submap_from_scan, winner);
  ASSERT_TRUE(with.rival);
  EXPECT_NEAR(with.rival->score, best, kRounding);
  EXPECT_NEAR(PlainScore(world, with.rival->submap_from_scan), best, kRounding);
  EXPECT_GT((with.rival->submap_from_scan.translation - winner.translation).norm(), min_distance);
  EXPECT_FALSE(search_with(min_score, {min_distance, share + 1e-9}).rival);
}

TEST(SearchWithRival, FindsTheOnlyOneOrNone) {
  constexpr double kMinDistance = 0.12;  // [m]
  int num_windows = 0;
  for (int seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    const RandomSearch search(seed);
    SearchTrace trace;
    const SearchOutcome outcome = search.Run(0.0, &trace);
    if (trace.window.num_linear_steps < 6) continue;  // nothing may lie so far away
    ++num_windows;
    ExpectTheOnlyRival(search.world(), trace.window, outcome.winner->submap_from_scan, kMinDistance,
                       [&](double min_score, const RivalCriterion& rival) {
                         return search.RunWithRival(min_score, rival);
                       });
  }
  EXPECT_GT(num_windows, 20);
}

/// Windows of many squares, and many angles that are bounded together.
TEST(SearchWithRival, FindsTheOnlyOneOrNoneInWideWindows) {
  constexpr double kLinearWindow = 1.5;   // [m]
  constexpr double kAngularWindow = 0.3;  // [rad]
  for (int seed = 0; seed < 30; ++seed) {
    SCOPED_TRACE(seed);
    Random random(seed);
    const RandomWorld world = MakeRandomWorld(&random);
    const BranchAndBoundMatcher matcher(world.grid, 7);
    const Pose2 guess =
        world.submap_from_scan *
        Pose2{random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-0.2, 0.2)};
    const SearchOutcome outcome =
        matcher.Search(world.points_in_scan, guess, kLinearWindow, kAngularWindow, 0.0);
    const SearchWindow window =
        MakeSearchWindow(world.points_in_scan, guess, kLinearWindow, kAngularWindow, 0.05);
    ExpectTheOnlyRival(world, window, outcome.winner->submap_from_scan, 0.2,
                       [&](double min_score, const RivalCriterion& rival) {
                         return matcher.SearchWithRival(world.points_in_scan, guess, kLinearWindow,
                                                        kAngularWindow, min_score, rival);
                       });
  }
}

TEST(SearchWithRival, HasNoneWithoutAWinner) {
  const SearchOutcome outcome = RandomSearch(1).RunWithRival(0.89, {0.12, 0.1});
  EXPECT_FALSE(outcome.winner);
  EXPECT_FALSE(outcome.rival);
}

TEST(SearchWholeSubmap, OfAnEmptySubmapFindsNothing) {
  const ProbabilityGrid nothing_known(0.05);
  const SearchOutcome outcome =
      BranchAndBoundMatcher(nothing_known, 3).SearchWholeSubmap({{1.0, 0.0}}, 0.3);
  EXPECT_FALSE(outcome.winner);
  EXPECT_DOUBLE_EQ(outcome.score_bound, kMinProbability);
}

}  // namespace
}  // namespace loopscope
