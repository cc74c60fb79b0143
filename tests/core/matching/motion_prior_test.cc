// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/motion_prior.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr double kExponent = 0.1;

float WeightOf(const MotionPrior& prior, const Pose2& motion) {
  return prior.Weight(prior.PlaceBin(motion.translation).value(),
                      prior.TurnBin(motion.rotation).value());
}

TEST(MotionPrior, WeighsTheLikeliestMotionOne) {
  const MotionPrior prior({Pose2(0.6, 0.0, 0.1)}, kExponent);
  EXPECT_EQ(WeightOf(prior, Pose2(0.6, 0.0, 0.1)), 1.0F);
}

TEST(MotionPrior, WeighsAMotionThatNeverWasByTheLeastDensity) {
  const MotionPrior prior({Pose2(0.6, 0.0, 0.0)}, kExponent);
  EXPECT_NEAR(WeightOf(prior, Pose2(-0.6, 0.0, 0.0)), std::pow(1e-5, kExponent), 1e-6);
  EXPECT_NEAR(WeightOf(prior, Pose2(0.6, 0.0, 1.0)), std::pow(1e-5, kExponent), 1e-6);
}

TEST(MotionPrior, CountsHowOftenAMotionWas) {
  std::vector<Pose2> motions(30, Pose2(0.6, 0.0, 0.0));
  motions.emplace_back(0.0, 0.0, 1.0);
  EXPECT_NEAR(WeightOf(MotionPrior(motions, kExponent), motions.back()),
              std::pow(1.0 / 30.0, kExponent), 1e-6);
}

TEST(MotionPrior, BlursEachMotionByOneAndAHalfBins) {
  const MotionPrior prior({Pose2(0.6, 0.0, 0.0)}, kExponent);
  const double one_bin_off = std::exp(-0.5 / (1.5 * 1.5));
  const double step = 0.1;
  for (const Pose2& off : {Pose2(0.6 - step, 0.0, 0.0), Pose2(0.6 + step, 0.0, 0.0),
                           Pose2(0.6, step, 0.0), Pose2(0.6, 0.0, DegreesToRadians(-4.0))}) {
    EXPECT_NEAR(WeightOf(prior, off), std::pow(one_bin_off, kExponent), 1e-6);
  }
  EXPECT_NEAR(WeightOf(prior, Pose2(0.6 + step, -step, DegreesToRadians(4.0))),
              std::pow(one_bin_off, 3.0 * kExponent), 1e-6);
}

TEST(MotionPrior, ReachesThreeTimesAsFarAsTheRobotUsuallyMoves) {
  EXPECT_NEAR(MotionPrior({Pose2(0.0, -0.6, 0.0)}, kExponent).reach(), 2.0, 1e-12);
  EXPECT_NEAR(MotionPrior({Pose2()}, kExponent).reach(), 1.0, 1e-12);
  EXPECT_NEAR(MotionPrior({Pose2(70.0, 0.0, 0.0)}, kExponent).reach(), 10.0, 1e-12);
}

TEST(MotionPrior, HasNoBinForWhatItDoesNotReach) {
  const MotionPrior prior({Pose2(0.6, 0.0, 0.0)}, kExponent);
  for (const Eigen::Vector2d& corner :
       {Eigen::Vector2d(2.04, 2.04), Eigen::Vector2d(-2.04, -2.04), Eigen::Vector2d(2.04, -2.04)}) {
    const std::optional<int> bin = prior.PlaceBin(corner);
    ASSERT_TRUE(bin);
    EXPECT_GE(*bin, 0);
    EXPECT_LT(*bin, MotionPrior::kNumPlaces);
  }
  EXPECT_FALSE(prior.PlaceBin({2.06, 0.0}));
  EXPECT_FALSE(prior.PlaceBin({0.0, -2.06}));
  EXPECT_FALSE(prior.PlaceBin({std::nan(""), 0.0}));
  EXPECT_EQ(prior.TurnBin(MotionPrior::kAngularReach), MotionPrior::kNumTurns - 1);
  EXPECT_EQ(prior.TurnBin(-MotionPrior::kAngularReach), 0);
  EXPECT_FALSE(prior.TurnBin(DegreesToRadians(95.0)));
}

TEST(MotionPrior, TakesTurnsOnceAround) {
  const MotionPrior prior({Pose2(0.6, 0.0, 2.0 * M_PI + 0.1)}, kExponent);
  EXPECT_EQ(WeightOf(prior, Pose2(0.6, 0.0, 0.1)), 1.0F);
}

TEST(MotionPrior, LeavesAsideWhatItDoesNotReach) {
  std::vector<Pose2> motions(99, Pose2(0.1, 0.0, 0.0));
  motions.emplace_back(50.0, 0.0, 0.0);
  const MotionPrior prior(motions, kExponent);
  EXPECT_EQ(WeightOf(prior, motions.front()), 1.0F);
}

TEST(UsualMotions, AreRootMeanSquares) {
  const std::vector<Pose2> motions{Pose2(3.0, 4.0, 0.1), Pose2(), Pose2(), Pose2(0.0, 0.0, -0.7)};
  EXPECT_NEAR(UsualWay(motions), 2.5, 1e-12);
  EXPECT_NEAR(UsualTurn(motions), std::sqrt(0.5 / 4.0), 1e-12);
}

}  // namespace
}  // namespace loopscope
