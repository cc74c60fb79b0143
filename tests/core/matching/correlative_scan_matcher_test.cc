// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/correlative_scan_matcher.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>

#include "core/matching/match_score.h"
#include "core/matching/search_lattice.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/exhaustive_search.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_world.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

/// The score as it is documented, with all of the pose applied to all of the points.
double PenalizedScore(const RandomWorld& world, const Pose2& guess, const Pose2& pose,
                      const CorrelativeScanMatcherOptions& options) {
  const double distance = (pose.translation - guess.translation).norm();
  const double turn = std::abs(NormalizeAngle(pose.rotation - guess.rotation));
  const double delta =
      options.translation_delta_cost_weight * distance + options.rotation_delta_cost_weight * turn;
  return MeanProbability(world.points_in_scan, pose, world.grid) * std::exp(-delta * delta);
}

TEST(MatchCorrelative, FindsTheBestPoseOfItsWindow) {
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const RandomWorld world = MakeRandomWorld(&random);
    const Pose2 guess = world.submap_from_scan * Pose2(random.Uniform(-0.2, 0.2), 0.1, 0.1);
    const CorrelativeScanMatcherOptions options{0.17, 0.15, random.Uniform(0.0, 3.0),
                                                random.Uniform(0.0, 3.0)};
    const CorrelativeMatch match =
        MatchCorrelative(world.points_in_scan, world.grid, guess, options);
    double best = 0.0;
    const SearchWindow window =
        MakeSearchWindow(world.points_in_scan, guess, options.linear_search_window,
                         options.angular_search_window, world.grid.resolution());
    ForEachPose(window, [&](CellIndex offset, int angle) {
      best =
          std::max(best, PenalizedScore(world, guess, PlainPose(window, offset, angle), options));
    });
    EXPECT_NEAR(match.score, best, 1e-9) << "world " << i;
    EXPECT_NEAR(PenalizedScore(world, guess, match.submap_from_scan, options), best, 1e-9);
  }
}

TEST(MatchCorrelative, ReachesTheCornersOfItsWindow) {
  for (const CellIndex corner : {CellIndex{-2, -2}, {-2, 2}, {2, -2}, {2, 2}}) {
    const ProbabilityGrid grid = GridDrawn({"9"}, 0.05, corner);
    const CorrelativeMatch match =
        MatchCorrelative({{0.0, 0.0}}, grid, Pose2(), {0.1, 0.0, 0.1, 0.1});
    EXPECT_THAT(match.submap_from_scan, PoseNear(Pose2(CenterOf(corner, 0.05), 0.0), 1e-12, 0.0));
  }
}

TEST(MatchCorrelative, StaysNearTheGuessIfNothingElseTells) {
  // The middle of a wide wall, where every pose of the window scores the same.
  const ProbabilityGrid grid =
      GridDrawn({"9999999", "9999999", "9999999", "9999999", "9999999", "9999999", "9999999"}, 0.05,
                {-3, -3});
  const Pose2 guess(0.004, -0.003, 0.2);
  const CorrelativeMatch match = MatchCorrelative({{0.01, 0.0}}, grid, guess, {0.1, 0.3, 0.1, 0.1});
  EXPECT_EQ(match.submap_from_scan, guess);
  EXPECT_NEAR(match.score, 0.9, 1e-9);
}

TEST(MatchCorrelative, BringsAScanOfARoomToACellsNearness) {
  const SimulatedRoom room;
  const Pose2 truth(2.0, 0.7, 0.4);
  const PointCloud points = room.ScanAt(truth);
  const Pose2 guess = truth * Pose2(0.13, -0.11, 0.15);
  const CorrelativeMatch match =
      MatchCorrelative(points, room.grid(), guess, {0.2, 0.25, 0.1, 0.1});
  EXPECT_THAT(match.submap_from_scan, PoseNear(truth, 0.05, 0.02));
}

}  // namespace
}  // namespace loopscope
