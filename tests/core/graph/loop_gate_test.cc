// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_gate.h"

#include <gtest/gtest.h>

#include "core/matching/match_score.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

const Eigen::AlignedBox2d kNodeBox(Eigen::Vector2d(0.0, -1.0), Eigen::Vector2d(10.0, 1.0));

ConstraintBuilderOptions Options() {
  ConstraintBuilderOptions options;
  options.max_constraint_distance = 5.0;
  options.linear_search_window_per_meter = 0.1;
  options.angular_search_window_per_meter = 0.01;
  options.max_linear_search_window = 4.0;
  options.fast_correlative_scan_matcher.linear_search_window = 1.0;
  options.fast_correlative_scan_matcher.angular_search_window = 0.2;
  return options;
}

LoopGate GateAt(double x, double y, double way) {
  return EvaluateLoopGate(Pose2(x, y, 1.0), kNodeBox, way, Options());
}

TEST(LoopGate, MeasuresTheDistanceToTheBoxOfTheNodes) {
  EXPECT_EQ(GateAt(5.0, 0.5, 0.0).distance, 0.0);
  EXPECT_DOUBLE_EQ(GateAt(13.0, 5.0, 0.0).distance, 5.0);
  EXPECT_DOUBLE_EQ(GateAt(5.0, -3.0, 0.0).distance, 2.0);
}

TEST(CountedWay, CountsWhatLiesBetweenNodesFarApartForMore) {
  ConstraintBuilderOptions options = Options();
  EXPECT_EQ(CountedWay(0.7, false, options), 0.7);
  options.search_window_growth_per_gap = 1.5;
  EXPECT_DOUBLE_EQ(CountedWay(0.2, false, options), 0.2 * 1.3);
  EXPECT_DOUBLE_EQ(CountedWay(1.0, false, options), 2.5);
  EXPECT_DOUBLE_EQ(CountedWay(4.0, false, options), 10.0) << "no more than that for a metre";
}

TEST(CountedWay, IsLongerToANodeThatMatchedNowhere) {
  ConstraintBuilderOptions options = Options();
  options.unmatched_node_way = 50.0;
  EXPECT_EQ(CountedWay(0.7, true, options), 50.7);
  EXPECT_EQ(CountedWay(0.7, false, options), 0.7);
}

TEST(LoopGate, OpensTheWindowWithTheWay) {
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 0.0).linear_window, 1.0);
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 20.0).linear_window, 3.0);
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 0.0).angular_window, 0.2);
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 20.0).angular_window, 0.4);
  EXPECT_EQ(GateAt(0.0, 0.0, 20.0).way, 20.0);
}

TEST(LoopGate, OpensNoFartherThanToItsLimits) {
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 1e4).linear_window, 4.0);
  EXPECT_DOUBLE_EQ(GateAt(0.0, 0.0, 1e4).angular_window, M_PI);
}

TEST(LoopGate, NeverIsSmallerThanTheWindowWithoutGrowth) {
  ConstraintBuilderOptions options = Options();
  options.max_linear_search_window = 0.5;
  EXPECT_EQ(EvaluateLoopGate(Pose2(), kNodeBox, 20.0, options).linear_window, 1.0);
}

TEST(LoopGate, IsNearUpToItsGreatestDistanceAtMost) {
  EXPECT_DOUBLE_EQ(MaxGateDistance(Options()), 8.0);
  EXPECT_TRUE(GateAt(17.99, 0.0, 1e4).is_near);
  EXPECT_FALSE(GateAt(18.01, 0.0, 1e4).is_near);
  ConstraintBuilderOptions options = Options();
  options.max_linear_search_window = 0.5;
  EXPECT_DOUBLE_EQ(MaxGateDistance(options), 5.0) << "where windows do not grow";
}

TEST(LoopGate, LetsInWhatIsNearEnoughForTheDriftOfTheWay) {
  EXPECT_TRUE(GateAt(14.99, 0.0, 0.0).is_near);
  EXPECT_FALSE(GateAt(15.01, 0.0, 0.0).is_near);
  EXPECT_TRUE(GateAt(16.99, 0.0, 20.0).is_near);
  EXPECT_FALSE(GateAt(17.01, 0.0, 20.0).is_near);
}

TEST(SamplingShare, IsLessForWideWindowsAndForNodesThatHardlyMoved) {
  ConstraintBuilderOptions options = Options();
  EXPECT_EQ(SamplingShare(20.0, 0.01, options), 1.0) << "off";
  options.full_sampling_search_window = 4.0;
  EXPECT_EQ(SamplingShare(4.0, 0.01, options), 1.0);
  EXPECT_DOUBLE_EQ(SamplingShare(16.0, 0.01, options), 0.25);
  options.full_sampling_gap = 0.5;
  EXPECT_EQ(SamplingShare(4.0, 0.5, options), 1.0);
  EXPECT_DOUBLE_EQ(SamplingShare(4.0, 0.3, options), 0.6);
  EXPECT_DOUBLE_EQ(SamplingShare(16.0, 0.3, options), 0.15);
  EXPECT_DOUBLE_EQ(SamplingShare(4.0, 0.0, options), 0.25) << "it may have turned";
}

class MinLoopScoreInARoom : public ::testing::Test {
 protected:
  double MinScore(const std::vector<PlacedScan>& own_nodes) const {
    return MinLoopScore(own_nodes, room_.grid(), options_);
  }

  const SimulatedRoom room_;
  const Pose2 pose_{1.0, 0.5, 0.0};
  const PointCloud points_ = room_.ScanAt(pose_);
  const Pose2 other_pose_{2.0, 0.5, 0.4};
  const PointCloud nothing_;
  ConstraintBuilderOptions options_;
};

TEST_F(MinLoopScoreInARoom, IsAShareOfWhatTheSubmapsNodesScoreOnAverage) {
  options_.min_score = 0.01;
  options_.min_relative_score = 0.5;
  const double mean = 0.5 * (MeanProbability(points_, pose_, room_.grid()) +
                             MeanProbability(points_, other_pose_, room_.grid()));
  EXPECT_DOUBLE_EQ(MinScore({{&points_, pose_}, {&points_, other_pose_}}), 0.5 * mean);
}

TEST_F(MinLoopScoreInARoom, LeavesOutNodesWithoutPoints) {
  options_.min_score = 0.01;
  options_.min_relative_score = 0.5;
  EXPECT_EQ(MinScore({{&points_, pose_}, {&nothing_, pose_}}), MinScore({{&points_, pose_}}));
}

TEST_F(MinLoopScoreInARoom, IsMinScoreAtLeast) {
  options_.min_score = 0.55;
  options_.min_relative_score = 0.1;
  EXPECT_EQ(MinScore({{&points_, pose_}}), 0.55);
  EXPECT_EQ(MinScore({}), 0.55);
  EXPECT_EQ(MinScore({{&nothing_, pose_}}), 0.55);
}

}  // namespace
}  // namespace loopscope
