// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/pose_extrapolator.h"

#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr std::nullopt_t kNoOdometry = std::nullopt;
constexpr MotionKnowledge kKnown{true, true};

const OdometryCalibration kUncalibrated(0.0);
const SteadyPace kByStamps(0);

const Pose2 kStart(1.0, 2.0, 0.3);
const Pose2 kSecondMotion(0.5, 0.1, 0.2);  // the motion of a second, in the frame of the robot

/// Knows the robot at times 10 s and 11 s.
PoseExtrapolator MovingExtrapolator() {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  extrapolator.AddPose(10.0, kStart, kNoOdometry, kKnown);
  extrapolator.AddPose(11.0, kStart * kSecondMotion, kNoOdometry, kKnown);
  return extrapolator;
}

TEST(PoseExtrapolator, BeginsAtTheIdentity) {
  EXPECT_EQ(PoseExtrapolator(kUncalibrated, kByStamps, 1.0).Predict(5.0, Pose2(3.0, 2.0, 1.0)),
            Pose2());
}

TEST(PoseExtrapolator, StaysWhenItKnowsOnlyOnePose) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  extrapolator.AddPose(10.0, kStart, kNoOdometry, kKnown);
  EXPECT_EQ(extrapolator.Predict(11.0, kNoOdometry), kStart);
}

TEST(PoseExtrapolator, AddsTheMotionThatOdometryMeasured) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  const Pose2 odom_from_base(-4.0, 1.0, 2.5);
  extrapolator.AddPose(10.0, kStart, odom_from_base, kKnown);
  EXPECT_THAT(extrapolator.Predict(11.0, odom_from_base * kSecondMotion),
              PoseNear(kStart * kSecondMotion, 1e-12, 1e-12));
}

TEST(PoseExtrapolator, GoesOnFromWhereOdometryBeganWhileMatchesHardlyCorrectIt) {
  constexpr MotionKnowledge kGoesOn{true, true, true};
  const Pose2 correction(-0.01, 0.0, 0.0);
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  const Pose2 odom_from_base(-4.0, 1.0, 2.5);
  const Pose2 odom_from_second = odom_from_base * kSecondMotion;
  const Pose2 odom_from_third = odom_from_second * kSecondMotion;
  const Pose2 second = kStart * kSecondMotion * correction;
  extrapolator.AddPose(10.0, kStart, odom_from_base, kKnown);
  extrapolator.AddPose(11.0, second, odom_from_second, kGoesOn);
  EXPECT_EQ(extrapolator.LastPose(), second);
  EXPECT_THAT(extrapolator.Predict(12.0, odom_from_third),
              PoseNear(kStart * kSecondMotion * kSecondMotion, 1e-12, 1e-12));
  extrapolator.AddPose(11.0, second, odom_from_second, kKnown);
  EXPECT_THAT(extrapolator.Predict(12.0, odom_from_third),
              PoseNear(second * kSecondMotion, 1e-12, 1e-12));
  extrapolator.AddPose(12.0, second, kNoOdometry, kGoesOn);
  extrapolator.AddPose(13.0, second, odom_from_second, kGoesOn);
  EXPECT_THAT(extrapolator.Predict(14.0, odom_from_third),
              PoseNear(second * kSecondMotion, 1e-12, 1e-12))
      << "it was not known in between";
}

TEST(PoseExtrapolator, BelievesOdometryWhateverTheStampsSay) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  const Pose2 odom_from_base(9.0, 9.0, 1.0);
  extrapolator.AddPose(10.0, Pose2(), Pose2(), kKnown);
  extrapolator.AddPose(11.0, kStart, odom_from_base, kKnown);
  EXPECT_THAT(extrapolator.Predict(10.5, odom_from_base * kSecondMotion),
              PoseNear(kStart * kSecondMotion, 1e-12, 1e-12));
}

TEST(PoseExtrapolator, KeepsTheVelocityWithoutOdometry) {
  const PoseExtrapolator extrapolator = MovingExtrapolator();
  EXPECT_THAT(extrapolator.Predict(12.0, kNoOdometry),
              PoseNear(kStart * kSecondMotion * kSecondMotion, 1e-12, 1e-12));
  EXPECT_THAT(extrapolator.Predict(11.5, kNoOdometry),
              PoseNear(kStart * kSecondMotion * Pose2(0.25, 0.05, 0.1), 1e-12, 1e-12));
}

TEST(PoseExtrapolator, KeepsTheVelocityWhereOdometryBeginsOrEnds) {
  PoseExtrapolator extrapolator = MovingExtrapolator();
  const Pose2 kept = extrapolator.Predict(12.0, kNoOdometry);
  EXPECT_EQ(extrapolator.Predict(12.0, Pose2(7.0, 7.0, 1.0)), kept);
  extrapolator.AddPose(12.0, kept, Pose2(7.0, 7.0, 1.0), kKnown);
  EXPECT_THAT(extrapolator.Predict(13.0, kNoOdometry),
              PoseNear(kept * kSecondMotion, 1e-12, 1e-12));
}

TEST(PoseExtrapolator, TellsWhereTheVelocityLeadsWhateverOdometrySays) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  extrapolator.AddPose(10.0, kStart, Pose2(), kKnown);
  extrapolator.AddPose(11.0, kStart * kSecondMotion, Pose2(), kKnown);  // odometry stands still
  EXPECT_THAT(extrapolator.Predict(12.0, Pose2()), PoseNear(kStart * kSecondMotion, 1e-12, 1e-12));
  EXPECT_THAT(extrapolator.PredictByVelocity(12.0),
              PoseNear(kStart * kSecondMotion * kSecondMotion, 1e-12, 1e-12));
}

TEST(PoseExtrapolator, FollowsAChangeOfVelocityAsFarAsItsGainSays) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 0.25);
  extrapolator.AddPose(10.0, Pose2(), kNoOdometry, kKnown);
  extrapolator.AddPose(11.0, Pose2(1.0, 0.0, 0.0), kNoOdometry, kKnown);
  extrapolator.AddPose(12.0, Pose2(3.0, 0.0, 0.1), kNoOdometry, kKnown);
  const Pose2 last(3.0, 0.0, 0.1);
  EXPECT_THAT(extrapolator.Predict(13.0, kNoOdometry),
              PoseNear(last * Pose2(1.25, 0.0, 0.1), 1e-12, 1e-12))
      << "but for the turn, which scans tell well";
}

TEST(PoseExtrapolator, GoesOnFromScanToScanWhereStampsJitter) {
  PoseExtrapolator extrapolator(kUncalibrated, SteadyPace(50), 1.0);
  Pose2 local_from_base;
  for (const double time : {0.0, 0.1, 1.0, 1.0, 2.1, 2.2}) {
    extrapolator.AddPose(time, local_from_base, kNoOdometry, kKnown);
    local_from_base = local_from_base * kSecondMotion;
  }
  EXPECT_THAT(extrapolator.Predict(2.21, kNoOdometry), PoseNear(local_from_base, 1e-12, 1e-12));
}

TEST(PoseExtrapolator, DoesNotStretchTheMotionOverAPause) {
  const Pose2 after_pause = MovingExtrapolator().Predict(1011.0, kNoOdometry);
  EXPECT_THAT(after_pause, PoseNear(kStart * kSecondMotion * Pose2(1.5, 0.3, 0.6), 1e-12, 1e-12));
}

TEST(PoseExtrapolator, StaysWhenTimeRunsBackwards) {
  PoseExtrapolator extrapolator = MovingExtrapolator();
  EXPECT_THAT(extrapolator.Predict(9.0, kNoOdometry),
              PoseNear(kStart * kSecondMotion, 1e-12, 1e-12));
  extrapolator.AddPose(9.0, kStart, kNoOdometry, kKnown);
  EXPECT_EQ(extrapolator.Predict(10.0, kNoOdometry), kStart);
}

TEST(PoseExtrapolator, StaysAfterTwoPosesOfTheSameTime) {
  PoseExtrapolator extrapolator = MovingExtrapolator();
  extrapolator.AddPose(11.0, kStart, kNoOdometry, kKnown);
  EXPECT_EQ(extrapolator.Predict(12.0, kNoOdometry), kStart);
}

TEST(PoseExtrapolator, TakesAMotionAsMeasuredThatHasOdometryAtBothEnds) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  const Pose2 odom_from_base(-4.0, 1.0, 2.5);
  EXPECT_FALSE(extrapolator.MotionIsMeasured(odom_from_base)) << "it begins somewhere";
  extrapolator.AddPose(10.0, kStart, odom_from_base, kKnown);
  EXPECT_TRUE(extrapolator.MotionIsMeasured(odom_from_base));
  EXPECT_FALSE(extrapolator.MotionIsMeasured(kNoOdometry));
  extrapolator.AddPose(11.0, kStart, kNoOdometry, kKnown);
  EXPECT_FALSE(extrapolator.MotionIsMeasured(odom_from_base));
}

TEST(PoseExtrapolator, TellsMotionsThatOdometryHardlyEverMeasures) {
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  const Pose2 jump(0.0, 0.0, 0.5);
  EXPECT_FALSE(extrapolator.IsUnusual(jump)) << "it begins somewhere";
  extrapolator.AddPose(10.0, kStart, Pose2(), kKnown);
  EXPECT_TRUE(extrapolator.IsUnusual(jump));
  EXPECT_FALSE(extrapolator.IsUnusual(Pose2(1.0, 0.0, 0.0)));
  extrapolator.AddPose(11.0, kStart, jump, kKnown);
  EXPECT_FALSE(extrapolator.IsUnusual(jump * jump)) << "now it has";
  extrapolator.AddPose(12.0, kStart, kNoOdometry, kKnown);
  EXPECT_FALSE(extrapolator.IsUnusual(Pose2())) << "nothing was measured before";
}

TEST(PoseExtrapolator, TellsThatOdometryStandsStillIfItSaysTheSameAsBefore) {
  const Pose2 odom_from_base(-4.0, 1.0, 2.5);
  PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
  EXPECT_FALSE(extrapolator.StandsStill(odom_from_base)) << "there is none before";
  extrapolator.AddPose(10.0, kStart, odom_from_base, kKnown);
  EXPECT_TRUE(extrapolator.StandsStill(odom_from_base));
  EXPECT_FALSE(extrapolator.StandsStill(Pose2(-4.0, 1.0, 2.5001)));
  extrapolator.AddPose(11.0, kStart, kNoOdometry, kKnown);
  EXPECT_FALSE(extrapolator.StandsStill(odom_from_base)) << "nothing was measured before";
}

TEST(PoseExtrapolator, RemembersTheMotionsThatWereKnown) {
  const auto drive = [](const MotionKnowledge& knowledge) {
    PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
    for (int i = 0; i <= 20; ++i) {
      extrapolator.AddPose(i, Pose2(1.0 * i, 0.0, 0.0), kNoOdometry, knowledge);
    }
    return extrapolator.past_motions().SayMoreThanVelocity();
  };
  EXPECT_TRUE(drive({true, false}));
  EXPECT_FALSE(drive({false, false}));
}

TEST(PoseExtrapolator, DoubtsMotionsThatTheRobotNeverMadeWhereScansAreSparse) {
  const auto is_unusual_after = [](double way) {
    PoseExtrapolator extrapolator(kUncalibrated, kByStamps, 1.0);
    const Pose2 last(20.0 * way, 0.0, 0.0);
    for (int i = 0; i <= 20; ++i) {
      const Pose2 pose(way * i, 0.0, 0.0);
      extrapolator.AddPose(i, pose, pose, kKnown);
    }
    return extrapolator.IsUnusual(last * Pose2(3.0, 0.0, 0.0));
  };
  EXPECT_TRUE(is_unusual_after(1.0));
  EXPECT_FALSE(is_unusual_after(3.0));
  EXPECT_FALSE(is_unusual_after(0.1)) << "with many scans a metre the velocity tells as much";
}

}  // namespace
}  // namespace loopscope
