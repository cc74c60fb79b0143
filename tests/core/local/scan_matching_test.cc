// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/scan_matching.h"

#include <gtest/gtest.h>

#include "tests/support/pose_matchers.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

using ::testing::Not;

const Pose2 kTruth(2.0, 0.8, 0.4);

/// A prior that only a wide search can mend.
const Pose2 kWrongPrior = kTruth * Pose2(0.5, -0.4, DegreesToRadians(60.0));

class ScanMatching : public ::testing::Test {
 protected:
  ScanMatch Match(const Pose2& prior, double expected_score, bool prior_is_measured = false) const {
    return MatchScan(points_, room_.grid(), {prior, prior_is_measured, {}}, expected_score,
                     options_);
  }

  LocalSlamOptions options_;
  const SimulatedRoom room_;
  PointCloud points_ = room_.ScanAt(kTruth);
};

TEST_F(ScanMatching, RefinesThePrior) {
  const ScanMatch match = Match(kTruth * Pose2(0.03, 0.02, 0.01), 0.0);
  EXPECT_THAT(match.submap_from_base, PoseNear(kTruth, 0.02, 0.01));
  EXPECT_FALSE(match.submap_from_base_correlative);
}

TEST_F(ScanMatching, StartsFromWhatTheCorrelativeMatcherFindsIfThatIsOn) {
  options_.use_online_correlative_scan_matching = true;
  const ScanMatch match = Match(kTruth * Pose2(0.09, 0.08, 0.2), 0.0);
  ASSERT_TRUE(match.submap_from_base_correlative);
  EXPECT_THAT(*match.submap_from_base_correlative, PoseNear(kTruth, 0.06, 0.03));
  // (CS) is pulled back to the place of the prior, but not to its turn.
  EXPECT_THAT(match.submap_from_base, PoseNear(kTruth, 0.13, 0.01));
}

TEST_F(ScanMatching, LooksFurtherFromAPriorThatNobodyMeasured) {
  options_.use_online_correlative_scan_matching = true;
  const Pose2 prior = kTruth * Pose2(0.3, -0.2, 0.1);
  options_.unmeasured_prior_scale = 4.0;
  EXPECT_THAT(Match(prior, 0.0, true).submap_from_base, Not(PoseNear(kTruth, 0.15, 0.02)));
  EXPECT_THAT(Match(prior, 0.0, false).submap_from_base, PoseNear(kTruth, 0.08, 0.02));
  options_.unmeasured_prior_scale = 1.0;
  EXPECT_THAT(Match(prior, 0.0, false).submap_from_base, Not(PoseNear(kTruth, 0.15, 0.02)));
}

TEST_F(ScanMatching, StaysNearerToAPriorThatWasMeasuredOverAShortWay) {
  const Pose2 prior = kTruth * Pose2(0.04, 0.03, 0.0);
  const auto moved = [&](double motion_size) {
    MatchPrior measured{prior, true};
    measured.motion_size = motion_size;
    const ScanMatch match = MatchScan(points_, room_.grid(), measured, 0.0, options_);
    return (match.submap_from_base.translation - prior.translation).norm();
  };
  const double usual = moved(1.0);
  EXPECT_GT(usual, 0.02);
  EXPECT_EQ(moved(0.01), usual) << "by default";
  options_.full_prior_motion = 0.2;
  EXPECT_EQ(moved(0.2), usual);
  EXPECT_LT(moved(0.1), usual);
  EXPECT_LT(moved(0.05), moved(0.1));
  EXPECT_EQ(moved(0.02), moved(0.05)) << "a robot may slip";
  EXPECT_EQ(moved(0.0), moved(0.05));
}

TEST(SizeOf, IsTheWayOrThatOfATurn) {
  EXPECT_DOUBLE_EQ(SizeOf(Pose2(3.0, -4.0, 0.1)), 5.0);
  EXPECT_DOUBLE_EQ(SizeOf(Pose2(0.03, 0.0, -0.1)), 0.2);
}

TEST_F(ScanMatching, BelievesTheVelocityWhereItMatchesAndOdometryDoesNot) {
  options_.use_online_correlative_scan_matching = true;
  options_.second_prior_relative_score = 0.8;
  const Pose2 by_velocity = kTruth * Pose2(0.03, 0.02, 0.01);
  const double good_score = Match(by_velocity, 0.0).score;
  const auto match = [&](const Pose2& second_prior, double expected_score) {
    return MatchScan(points_, room_.grid(), {kWrongPrior, true, second_prior}, expected_score,
                     options_);
  };
  EXPECT_THAT(match(by_velocity, good_score).submap_from_base, PoseNear(kTruth, 0.02, 0.01));
  EXPECT_EQ(match(by_velocity, good_score).start, MatchStart::kVelocity);
  EXPECT_EQ(match(by_velocity, 0.0).start, MatchStart::kPrior);
  EXPECT_EQ(match(by_velocity, 0.0).submap_from_base,
            Match(kWrongPrior, 0.0, true).submap_from_base)
      << "it matches as well as can be expected where odometry has it";
  EXPECT_EQ(match(by_velocity, 2.0 * good_score).submap_from_base,
            Match(kWrongPrior, 0.0, true).submap_from_base)
      << "it matches at neither";
  options_.second_prior_relative_score = 0.0;
  EXPECT_THAT(match(by_velocity, good_score).submap_from_base, Not(PoseNear(kTruth, 0.2, 0.2)));
}

TEST_F(ScanMatching, SearchesNotWhereTheWayIsTrusted) {
  options_.recovery.min_relative_score = 0.6;
  constexpr double expected_score = 0.9;
  MatchPrior prior{kWrongPrior, true};
  EXPECT_EQ(MatchScan(points_, room_.grid(), prior, expected_score, options_).start,
            MatchStart::kRecovery);
  prior.is_trusted = true;
  const ScanMatch match = MatchScan(points_, room_.grid(), prior, expected_score, options_);
  EXPECT_EQ(match.start, MatchStart::kNone);
  EXPECT_EQ(match.submap_from_base, kWrongPrior);
}

TEST_F(ScanMatching, SearchesSoonerWhereNobodyMeasuredTheMotion) {
  options_.recovery.min_relative_score = 0.2;
  const double near_score = Match(kWrongPrior, 0.0).score;
  const double expected_score = near_score / 0.7;
  const auto start = [&](bool measured) {
    return Match(kWrongPrior, expected_score, measured).start;
  };
  options_.recovery.unmeasured_min_relative_score = 0.9;
  EXPECT_EQ(start(false), MatchStart::kRecovery);
  EXPECT_EQ(start(true), MatchStart::kPrior);
  options_.recovery.min_gain = 0.85;
  EXPECT_EQ(start(false), MatchStart::kRecovery) << "any gain is enough";
  options_.recovery.unmeasured_min_relative_score = 0.6;
  EXPECT_EQ(start(false), MatchStart::kPrior);
}

TEST_F(ScanMatching, GoesFarFromAPriorThatNobodyMeasuredForWhatMatchesMuchBetterOnly) {
  options_.recovery.min_relative_score = 0.2;
  options_.recovery.unmeasured_min_relative_score = 0.9;
  const double near_score = Match(kWrongPrior, 0.0).score;
  const double expected_score = near_score / 0.7;
  const double ratio = Match(kTruth, 0.0).score / near_score;
  const auto start = [&] { return Match(kWrongPrior, expected_score).start; };
  options_.recovery.unmeasured_angular_search_window = DegreesToRadians(1.0);
  options_.recovery.unmeasured_linear_search_window = 0.1;
  options_.recovery.unmeasured_min_score_ratio = 0.7 * ratio;
  EXPECT_EQ(start(), MatchStart::kRecovery);
  options_.recovery.unmeasured_min_score_ratio = 1.3 * ratio;
  EXPECT_THAT(Match(kWrongPrior, expected_score).submap_from_base, Not(PoseNear(kTruth, 0.2, 0.2)));
  options_.recovery.unmeasured_angular_search_window = DegreesToRadians(90.0);
  options_.recovery.unmeasured_linear_search_window = 1.0;
  EXPECT_EQ(start(), MatchStart::kRecovery) << "it is not far";
}

TEST_F(ScanMatching, SearchesWidelyForAScanThatMatchesWorseThanExpected) {
  options_.recovery.min_relative_score = 0.6;
  const ScanMatch match = Match(kWrongPrior, 0.9);
  EXPECT_THAT(match.submap_from_base, PoseNear(kTruth, 0.02, 0.01));
  EXPECT_TRUE(match.submap_from_base_correlative);
  EXPECT_EQ(match.start, MatchStart::kRecovery);
}

TEST_F(ScanMatching, StaysNearThePriorIfNothingBetterWasExpected) {
  options_.recovery.min_relative_score = 0.6;
  EXPECT_THAT(Match(kWrongPrior, 0.0).submap_from_base, Not(PoseNear(kTruth, 0.2, 0.2)));
}

TEST_F(ScanMatching, NeverSearchesWidelyIfThatIsOff) {
  options_.recovery.min_relative_score = 0.0;
  EXPECT_THAT(Match(kWrongPrior, 0.9).submap_from_base, Not(PoseNear(kTruth, 0.2, 0.2)));
}

TEST_F(ScanMatching, StaysAtThePriorIfItMatchesNowhereAsExpected) {
  options_.recovery.min_relative_score = 0.99;
  options_.recovery.linear_search_window = 0.2;
  options_.recovery.angular_search_window = 0.1;
  EXPECT_EQ(Match(kWrongPrior, 0.9, true).submap_from_base, kWrongPrior);
  EXPECT_EQ(Match(kWrongPrior, 0.9, true).start, MatchStart::kNone);
  EXPECT_EQ(Match(kWrongPrior, 0.9, false).start, MatchStart::kNone);
}

TEST_F(ScanMatching, KeepsTheNearMatchOfAScanThatLooksMostlyWhereNothingIsKnown) {
  options_.recovery.min_relative_score = 0.6;
  options_.min_num_matched_points = 30;
  for (int i = 0; i < 3000; ++i) points_.emplace_back(20.0 + 0.01 * i, 40.0);
  const ScanMatch match = Match(kTruth * Pose2(0.03, 0.02, 0.01), 0.9, true);
  EXPECT_LT(match.score, 0.6 * 0.9);
  EXPECT_THAT(match.submap_from_base, PoseNear(kTruth, 0.03, 0.01));
  EXPECT_NE(match.submap_from_base, kTruth * Pose2(0.03, 0.02, 0.01));
  options_.min_num_matched_points = 5000;
  EXPECT_EQ(Match(kWrongPrior, 0.9, true).submap_from_base, kWrongPrior) << "too few are known";
}

TEST_F(ScanMatching, TakesWhatTheWideSearchFoundOnlyIfItGainsEnoughOverOdometry) {
  options_.recovery.min_relative_score = 0.6;
  options_.recovery.min_gain = 0.2;
  EXPECT_EQ(Match(kWrongPrior, 0.9, true).start, MatchStart::kRecovery);
  options_.recovery.min_gain = 0.85;
  EXPECT_EQ(Match(kWrongPrior, 0.9, true).start, MatchStart::kNone);
}

TEST_F(ScanMatching, FindsAScanByTheMotionsBefore) {
  const Pose2 motion(0.9, 0.1, DegreesToRadians(50.0));
  const MotionPrior prior({Pose2(1.0, 0.0, 0.0), Pose2(0.8, 0.0, DegreesToRadians(45.0))}, 0.05);
  const ScanMatch match =
      MatchAsBefore(points_, room_.grid(), kTruth * motion.Inverse(), prior, 0.0, options_);
  ASSERT_TRUE(match.submap_from_base_correlative);
  EXPECT_THAT(*match.submap_from_base_correlative, PoseNear(kTruth, 0.06, 0.03));
  EXPECT_THAT(match.submap_from_base, PoseNear(kTruth, 0.02, 0.01));
  EXPECT_EQ(match.start, MatchStart::kRecovery);
  EXPECT_NEAR(match.score, Match(kTruth, 0.0).score, 0.02);
}

}  // namespace
}  // namespace loopscope
