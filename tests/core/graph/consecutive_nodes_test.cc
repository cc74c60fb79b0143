// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/consecutive_nodes.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

OptimizationProblemOptions Options() {
  OptimizationProblemOptions options;
  options.local_slam_pose_translation_weight = 1.0;
  options.odometry_translation_weight = 2.0;
  return options;
}

const MeasuredNode kFirst{NodeId{3}, Pose2(1.0, 0.0, 0.0), Pose2(5.0, 0.0, 0.0)};

/// The second is a metre on as local SLAM has it, and at `x` [m] as odometry has it.
MeasuredNode SecondAt(double x) { return {NodeId{4}, Pose2(2.0, 0.0, 0.0), Pose2(x, 0.0, 0.0)}; }

TEST(RelateConsecutive, HasATermForEachThatMeasured) {
  const auto terms = RelateConsecutive(kFirst, SecondAt(5.9), Options());
  ASSERT_EQ(terms.size(), 2u);
  EXPECT_EQ(terms[0].first, NodeId{3});
  EXPECT_EQ(terms[0].second, NodeId{4});
  EXPECT_NEAR(terms[0].first_from_second.x(), 1.0, 1e-12);
  EXPECT_EQ(terms[0].translation_weight, 1.0);
  EXPECT_NEAR(terms[1].first_from_second.x(), 0.9, 1e-12);
  EXPECT_EQ(terms[1].translation_weight, 2.0);
}

TEST(RelateConsecutive, HasNoTermWithoutWeightOrOdometry) {
  OptimizationProblemOptions options = Options();
  options.local_slam_pose_translation_weight = options.local_slam_pose_rotation_weight = 0.0;
  EXPECT_EQ(RelateConsecutive(kFirst, SecondAt(5.9), options).size(), 1u);
  MeasuredNode second = SecondAt(5.9);
  second.odom_from_node.reset();
  EXPECT_TRUE(RelateConsecutive(kFirst, second, options).empty());
}

TEST(RelateConsecutive, LeavesOutOdometryThatLeaped) {
  EXPECT_EQ(RelateConsecutive(kFirst, SecondAt(90.0), Options()).size(), 2u);
  EXPECT_EQ(RelateConsecutive(kFirst, SecondAt(110.0), Options()).size(), 1u);
}

}  // namespace
}  // namespace loopscope
