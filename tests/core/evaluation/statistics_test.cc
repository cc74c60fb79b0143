// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/statistics.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(Statistics, AreThoseOfTheTextbook) {
  const Statistics statistics = StatisticsOf({4.0, 1.0, 2.0, 9.0});
  EXPECT_EQ(statistics.count, 4);
  EXPECT_DOUBLE_EQ(statistics.mean, 4.0);
  EXPECT_DOUBLE_EQ(statistics.standard_deviation, std::sqrt(38.0 / 3.0));
  EXPECT_DOUBLE_EQ(statistics.rmse, std::sqrt(102.0 / 4.0));
  EXPECT_DOUBLE_EQ(statistics.median, 3.0);
  EXPECT_DOUBLE_EQ(statistics.min, 1.0);
  EXPECT_DOUBLE_EQ(statistics.max, 9.0);
}

TEST(Statistics, OfOddNumbersHaveTheMiddleOneAsMedian) {
  EXPECT_DOUBLE_EQ(StatisticsOf({5.0, 1.0, 3.0}).median, 3.0);
}

TEST(Statistics, OfOneValueHaveNoDeviation) {
  EXPECT_EQ(StatisticsOf({5.0}).standard_deviation, 0.0);
}

TEST(Statistics, HaveADeviationOfThePopulationToo) {
  EXPECT_DOUBLE_EQ(PopulationDeviation(StatisticsOf({4.0, 1.0, 2.0, 9.0})), std::sqrt(38.0 / 4.0));
  EXPECT_EQ(PopulationDeviation(StatisticsOf({5.0})), 0.0);
  EXPECT_EQ(PopulationDeviation(StatisticsOf({})), 0.0);
}

TEST(Statistics, OfNothingAreZero) { EXPECT_EQ(StatisticsOf({}).count, 0); }

}  // namespace
}  // namespace loopscope
