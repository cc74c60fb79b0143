// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/true_relations.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

// Twice around a circle of 8 m, one pose a decimetre, which is one every 0.1 s.
Trajectory TwoRounds() {
  Trajectory trajectory;
  for (int i = 0; i < 1000; ++i) {
    const double angle = 0.1 * i / 8.0;
    trajectory.push_back(
        {0.1 * i, Pose2(0.0, 0.0, angle) * Pose2(8.0, 0.0, DegreesToRadians(90.0))});
  }
  return trajectory;
}

TEST(TrueRelations, AgreeWithTheTruth) {
  const Trajectory truth = TwoRounds();
  for (const Relation& relation : TrueRelations(truth)) {
    const Pose2 error = ErrorOf(relation, truth);
    EXPECT_LT(error.translation.norm(), 1e-9);
    EXPECT_NEAR(error.rotation, 0.0, 1e-9);
  }
}

TEST(TrueRelations, TieKeyframesOneMetreApart) {
  int num_steps = 0;
  for (const Relation& relation : TrueRelations(TwoRounds())) {
    if (relation.second_time - relation.first_time > 10.0) continue;
    EXPECT_NEAR(relation.first_from_second.translation.norm(), 1.05, 0.06);
    ++num_steps;
  }
  EXPECT_NEAR(num_steps, 93, 4);
}

TEST(TrueRelations, TieEachPlaceOfTheSecondRoundToTheFirst) {
  int num_revisits = 0;
  for (const Relation& relation : TrueRelations(TwoRounds())) {
    if (relation.second_time - relation.first_time < 10.0) continue;
    EXPECT_NEAR(relation.second_time - relation.first_time, 16.0 * 3.14159, 1.0);
    EXPECT_LT(relation.first_from_second.translation.norm(), 1.0);
    ++num_revisits;
  }
  EXPECT_NEAR(num_revisits, 47, 3);
}

TEST(TrueRelations, DoNotTieARobotThatTurnsBackToWhereItJustWas) {
  Trajectory trajectory;
  for (int i = 0; i <= 60; ++i) {
    const double x = 0.1 * (i <= 30 ? i : 60 - i);
    trajectory.push_back({0.1 * i, Pose2(x, 0.0, 0.0)});
  }
  for (const Relation& relation : TrueRelations(trajectory)) {
    EXPECT_LT(relation.second_time - relation.first_time, 2.5);
  }
}

TEST(TrueRelations, DoNotTieAStandingRobotToItself) {
  EXPECT_TRUE(TrueRelations(Trajectory(100, {0.0, Pose2()})).empty());
  EXPECT_TRUE(TrueRelations({}).empty());
}

}  // namespace
}  // namespace loopscope
