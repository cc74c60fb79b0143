// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/random.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(Random, GivesTheSameNumbersWithEveryStandardLibrary) {
  // The standard fixes the 10000th output of a default mt19937_64 as 9981545732273789042.
  Random random(5489);
  for (int i = 1; i < 10000; ++i) random.Uniform();
  EXPECT_DOUBLE_EQ(random.Uniform(), 9981545732273789042.0 / 18446744073709551616.0);
}

TEST(Random, GaussianHasTheMomentsOfANormalDistribution) {
  Random random(1);
  constexpr int kCount = 100000;
  double sum = 0.0, sum_of_squares = 0.0;
  int within_one_sigma = 0;
  for (int i = 0; i < kCount; ++i) {
    const double value = random.Gaussian(2.0);
    sum += value;
    sum_of_squares += value * value;
    within_one_sigma += std::abs(value) < 2.0;
  }
  EXPECT_NEAR(sum / kCount, 0.0, 0.03);
  EXPECT_NEAR(sum_of_squares / kCount, 4.0, 0.08);
  EXPECT_NEAR(within_one_sigma / double{kCount}, 0.6827, 0.006);
}

TEST(Random, BelowReachesAllValuesAndNoOther) {
  Random random(1);
  int seen[3] = {0, 0, 0};
  for (int i = 0; i < 3000; ++i) {
    const int value = random.Below(3);
    ASSERT_GE(value, 0);
    ASSERT_LT(value, 3);
    ++seen[value];
  }
  for (const int count : seen) EXPECT_NEAR(count, 1000, 120);
}

}  // namespace
}  // namespace loopscope
