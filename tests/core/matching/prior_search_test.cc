// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/prior_search.h"

#include <gmock/gmock.h>

#include "core/matching/search_lattice.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/exhaustive_search.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/random_world.h"

namespace loopscope {
namespace {

/// Motions that end near the truth, at other places, and some out of reach.
std::vector<Pose2> RandomMotions(const Pose2& true_motion, Random* random) {
  std::vector<Pose2> motions;
  for (int i = 0; i < 20; ++i) {
    const Pose2 near{true_motion.x() + random->Uniform(-0.1, 0.1),
                     true_motion.y() + random->Uniform(-0.1, 0.1),
                     true_motion.rotation + random->Uniform(-0.1, 0.1)};
    const Pose2 elsewhere{random->Uniform(-0.8, 0.8), random->Uniform(-0.8, 0.8),
                          random->Uniform(-2.0, 2.0)};
    motions.push_back(random->Below(3) == 0 ? elsewhere : near);
  }
  return motions;
}

/// 0 out of reach.
double WeightOf(const MotionPrior& prior, const Pose2& before, const Pose2& pose) {
  const Pose2 motion = before.Inverse() * pose;
  const std::optional<int> place_bin = prior.PlaceBin(motion.translation);
  const std::optional<int> turn_bin = prior.TurnBin(motion.rotation);
  return place_bin && turn_bin ? prior.Weight(*place_bin, *turn_bin) : 0.0;
}

/// The score as it is documented.
double WeighedScore(const RandomWorld& world, const MotionPrior& prior, const Pose2& before,
                    const Pose2& pose) {
  return PlainScore(world.points_in_scan, pose, world.grid) * WeightOf(prior, before, pose);
}

TEST(MatchWithPrior, FindsTheMostProbableOfAllPoses) {
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    RandomWorld world = MakeRandomWorld(&random);
    if (i % 2 == 1) {  // a scan of elsewhere, for which bounds tell little
      for (Eigen::Vector2d& point : world.points_in_scan) {
        point = {random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0)};
      }
    }
    const Pose2 true_motion{random.Uniform(-0.4, 0.4), random.Uniform(-0.1, 0.1),
                            random.Uniform(-0.7, 0.7)};
    const Pose2 before = world.submap_from_scan * true_motion.Inverse();
    const MotionPrior prior(RandomMotions(true_motion, &random), random.Uniform(0.0, 0.1));
    const SearchWindow window =
        MakeSearchWindow(world.points_in_scan, before, prior.reach(), MotionPrior::kAngularReach,
                         world.grid.resolution());
    double best = 0.0;
    ForEachPose(window, [&](CellIndex offset, int angle) {
      const Pose2 pose = PlainPose(window, offset, angle);
      if (kMaxProbability * WeightOf(prior, before, pose) <= best) return;
      best = std::max(best, WeighedScore(world, prior, before, pose));
    });
    const CorrelativeMatch match = MatchWithPrior(world.points_in_scan, world.grid, before, prior);
    EXPECT_NEAR(match.score, best, 1e-6) << "world " << i;
    EXPECT_NEAR(WeighedScore(world, prior, before, match.submap_from_scan), best, 1e-6);
  }
}

TEST(MatchWithPrior, TakesTheUsualMotionWhereOthersFitAlike) {
  // Of three walls across, each 0.8 m behind the other, the scan sees one.
  PointCloud points;
  for (int y = -10; y <= 10; ++y) points.emplace_back(0.0, 0.05 * y);
  const Drawing walls(21, "9...............9...............9");
  const ProbabilityGrid grid = GridDrawn(walls, 0.05, {-16, -10});
  for (const double way : {-0.8, 0.0, 0.8}) {
    const CorrelativeMatch match =
        MatchWithPrior(points, grid, Pose2(), MotionPrior({Pose2(way, 0.0, 0.0)}, 0.05));
    EXPECT_THAT(match.submap_from_scan, PoseNear(Pose2(way, 0.0, 0.0), 1e-9, 1e-9)) << way;
  }
}

}  // namespace
}  // namespace loopscope
