// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/error_histogram.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(ErrorHistogram, CountsErrorsInBarsOfEqualWidth) {
  // Bars are 0.1 wide.
  const ChartData data = ErrorHistogram("error [m]", {0.05, 0.01, 0.25}, 4.0);
  ASSERT_EQ(data.series.size(), 1u);
  const std::vector<ChartBar>& bars = data.series[0].bars;
  ASSERT_EQ(bars.size(), 2u);
  EXPECT_EQ(bars[0].high, 2.0);
  EXPECT_EQ(bars[1].high, 1.0);
  EXPECT_NEAR(bars[1].begin, 0.2, 1e-12);
  EXPECT_NEAR(bars[1].end, 0.3, 1e-12);
  EXPECT_EQ(data.y.max, 2.0);
}

TEST(ErrorHistogram, CountsLargerOnesInTheLastBar) {
  const ChartData data = ErrorHistogram("error [m]", {3.95, 4.0, 70.0}, 4.0);
  ASSERT_EQ(data.series[0].bars.size(), 1u);
  EXPECT_EQ(data.series[0].bars[0].high, 3.0);
}

TEST(ErrorHistogram, MarksTheRootMeanSquare) {
  const ChartData data = ErrorHistogram("error [m]", {3.0, 4.0}, 5.0);
  ASSERT_EQ(data.thresholds.size(), 1u);
  EXPECT_NEAR(data.thresholds[0].value, std::sqrt(12.5), 1e-12);
}

TEST(ErrorScale, IsRoundAndHoldsNearlyAll) {
  EXPECT_NEAR(ErrorScaleOf({0.3, 0.31, 0.32}), 0.5, 1e-12);
  EXPECT_NEAR(ErrorScaleOf({1.0}), 1.0, 1e-12);
  EXPECT_NEAR(ErrorScaleOf({7.0}), 10.0, 1e-12);
  std::vector<double> values(100, 0.015);
  values[3] = values[50] = 9.0;
  EXPECT_NEAR(ErrorScaleOf(values), 0.02, 1e-12);
  EXPECT_EQ(ErrorScaleOf({}), 1.0);
  EXPECT_EQ(ErrorScaleOf({0.0, 0.0}), 1.0);
}

}  // namespace
}  // namespace loopscope
