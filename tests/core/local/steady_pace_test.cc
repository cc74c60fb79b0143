// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/steady_pace.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

const Pose2 kMotion(0.2, 0.0, 0.1);

TEST(SteadyPace, BelievesStampsUntilItLearns) { EXPECT_EQ(SteadyPace(50).Stretch(1.7), 1.7); }

TEST(SteadyPace, GoesOnByScansWhereStampsJitter) {
  SteadyPace pace(50);
  pace.Learn(kMotion, 3.0, kMotion);
  pace.Learn(kMotion, 0.0, kMotion);
  EXPECT_EQ(pace.Stretch(1.7), 1.0);
}

TEST(SteadyPace, GoesOnByStampsWhereScansAreMissing) {
  SteadyPace pace(50);
  pace.Learn(kMotion, 2.0, Pose2(0.4, 0.0, 0.2));
  EXPECT_EQ(pace.Stretch(1.7), 1.7);
}

TEST(SteadyPace, ForgetsWhatWas) {
  SteadyPace pace(2);
  for (int i = 0; i < 20; ++i) pace.Learn(kMotion, 3.0, kMotion);
  EXPECT_EQ(pace.Stretch(1.7), 1.0);
  for (int i = 0; i < 5; ++i) pace.Learn(kMotion, 2.0, Pose2(0.4, 0.0, 0.2));
  EXPECT_EQ(pace.Stretch(1.7), 1.7);
}

TEST(SteadyPace, CountsTurnsTheShortWay) {
  SteadyPace pace(50);
  pace.Learn(Pose2(0.0, 0.0, 3.0), 2.0, Pose2(0.0, 0.0, 6.0 - 2.0 * M_PI));
  EXPECT_EQ(pace.Stretch(1.7), 1.7);
}

TEST(SteadyPace, LearnsNothingWithoutMemory) {
  SteadyPace pace(0);
  pace.Learn(kMotion, 3.0, kMotion);
  EXPECT_EQ(pace.Stretch(1.7), 1.7);
}

}  // namespace
}  // namespace loopscope
