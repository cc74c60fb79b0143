// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/past_motions.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

PastMotions Motions(int count, const Pose2& motion) {
  PastMotions motions;
  for (int i = 0; i < count; ++i) motions.Learn(motion);
  return motions;
}

TEST(PastMotions, SayMoreThanTheVelocityWhereScansAreSparse) {
  EXPECT_TRUE(Motions(20, Pose2(0.2, 0.3, 0.0)).SayMoreThanVelocity());
  EXPECT_TRUE(Motions(20, Pose2(0.0, 0.0, -0.11)).SayMoreThanVelocity());
  EXPECT_FALSE(Motions(20, Pose2(0.29, 0.0, 0.09)).SayMoreThanVelocity());
}

TEST(PastMotions, SayNothingUntilThereAreTwenty) {
  EXPECT_FALSE(Motions(19, Pose2(1.0, 0.0, 0.0)).SayMoreThanVelocity());
  EXPECT_FALSE(PastMotions().SayMoreThanVelocity());
}

TEST(PastMotions, ForgetAllButTheLastThreeHundred) {
  PastMotions motions = Motions(300, Pose2(6.0, 0.0, 0.0));
  for (int i = 0; i < 299; ++i) motions.Learn(Pose2());
  EXPECT_TRUE(motions.SayMoreThanVelocity()) << "one is left";
  motions.Learn(Pose2());
  EXPECT_FALSE(motions.SayMoreThanVelocity());
}

TEST(PastMotions, KnowWhatIsLikeOneOfThem) {
  PastMotions motions = Motions(20, Pose2(1.0, 0.0, 0.0));
  EXPECT_TRUE(motions.HaveOneLike(Pose2(1.0, 0.0, 0.0)));
  EXPECT_TRUE(motions.HaveOneLike(Pose2(0.3, 0.0, 0.0)));
  EXPECT_FALSE(motions.HaveOneLike(Pose2(0.2, 0.0, 0.0)));
  EXPECT_TRUE(motions.HaveOneLike(Pose2(1.0, 0.0, DegreesToRadians(-17.0))));
  EXPECT_FALSE(motions.HaveOneLike(Pose2(1.0, 0.0, DegreesToRadians(19.0))));
  EXPECT_FALSE(motions.HaveOneLike(Pose2(0.4, 0.0, DegreesToRadians(15.0)))) << "both in all";
  motions.Learn(Pose2(0.0, 0.0, DegreesToRadians(175.0)));
  EXPECT_TRUE(motions.HaveOneLike(Pose2(0.0, 0.0, DegreesToRadians(-175.0)))) << "the short way";
  EXPECT_TRUE(Motions(20, Pose2(0.0, 0.0, 0.5)).HaveOneLike(Pose2(0.1, 0.0, 0.5))) << "on the spot";
}

TEST(PastMotions, AreThoseOfAnyRobotUntilThereAreTwenty) {
  const auto weight = [](const PastMotions& motions, const Pose2& motion) {
    const MotionPrior prior = motions.Prior(1.0);
    return prior.Weight(*prior.PlaceBin(motion.translation), *prior.TurnBin(motion.rotation));
  };
  const Pose2 ahead(1.5, 0.0, 0.0);
  const Pose2 left(0.0, 0.0, DegreesToRadians(50.0));
  const Pose2 sideways(0.0, 1.5, 0.0);
  for (const int num_motions : {0, 19}) {
    const PastMotions few = Motions(num_motions, Pose2(1.0, 0.0, 0.0));
    EXPECT_GT(weight(few, ahead), 0.01F);
    EXPECT_GT(weight(few, left), 0.01F);
    EXPECT_LT(weight(few, sideways), 0.001F);
  }
  EXPECT_LT(weight(Motions(20, Pose2(1.0, 0.0, 0.0)), left), 0.001F);
}

}  // namespace
}  // namespace loopscope
