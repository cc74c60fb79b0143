// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scale_bar.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(RoundLengthTest, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(RoundLength(9.9), 5.0);
  EXPECT_DOUBLE_EQ(RoundLength(4.9), 2.0);
  EXPECT_DOUBLE_EQ(RoundLength(1.9), 1.0);
  EXPECT_DOUBLE_EQ(RoundLength(0.99), 0.5);
  EXPECT_DOUBLE_EQ(RoundLength(0.024), 0.02);
  EXPECT_DOUBLE_EQ(RoundLength(731.0), 500.0);
}

TEST(RoundLengthTest, IsTheLimitWhereThatIsRound) {
  for (int power = -4; power <= 4; ++power) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double length = factor * std::pow(10.0, power);
      EXPECT_NEAR(RoundLength(length), length, 1e-9 * length);
    }
  }
}

TEST(RoundLengthTest, UsesAtLeastTwoFifthsOfTheLimit) {
  for (double limit = 0.01; limit < 1000.0; limit *= 1.07) {
    EXPECT_LE(RoundLength(limit), limit * (1.0 + 1e-6));
    EXPECT_GE(RoundLength(limit), 0.4 * limit);
  }
}

TEST(LengthLabelTest, PicksTheUnitThatNeedsNoZeros) {
  EXPECT_EQ(LengthLabel(0.005), "5 mm");
  EXPECT_EQ(LengthLabel(0.01), "1 cm");
  EXPECT_EQ(LengthLabel(0.5), "50 cm");
  EXPECT_EQ(LengthLabel(1.0), "1 m");
  EXPECT_EQ(LengthLabel(200.0), "200 m");
  EXPECT_EQ(LengthLabel(1000.0), "1 km");
}

}  // namespace
}  // namespace loopscope
