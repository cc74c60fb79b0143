// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/chart_layers.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

constexpr Color kRed{255, 0, 0};

/// x from 0 to 10 and y from 0 to 100, on 20 x 40 from (1, 2).
ChartPlot Plot() {
  return {{1.0, 2.0, 20.0, 40.0}, {"", 0.0, 10.0, false}, {"", 0.0, 100.0, false}};
}

TEST(ChartLayersTest, PointsLieAtTheirValues) {
  ChartSeries series;
  series.points = {{5.0, 25.0, 0}, {10.0, 100.0, 1}};
  const auto dots = ChartSeriesLayer(Plot(), series, kRed, {});
  EXPECT_EQ(DataOf(dots)->GetNumberOfVerts(), 2);
  EXPECT_EQ(DataOf(dots)->GetNumberOfLines(), 0);
  EXPECT_EQ(PointOf(dots, 0), Eigen::Vector2d(11.0, 12.0));
  EXPECT_EQ(PointOf(dots, 1), Eigen::Vector2d(21.0, 42.0));
  EXPECT_EQ(loopscope::ColorOf(dots, 0), kRed);
  series.joined = true;
  EXPECT_EQ(DataOf(ChartSeriesLayer(Plot(), series, kRed, {}))->GetNumberOfLines(), 1);
}

TEST(ChartLayersTest, BarsReachFromLowToHigh) {
  ChartSeries series;
  series.bars = {{5.0, 10.0, 25.0, 50.0}};
  const auto bars = ChartSeriesLayer(Plot(), series, kRed, {});
  EXPECT_EQ(DataOf(bars)->GetNumberOfPolys(), 1);
  EXPECT_EQ(PointOf(bars, 0), Eigen::Vector2d(11.0, 12.0));
  EXPECT_EQ(PointOf(bars, 2), Eigen::Vector2d(21.0, 22.0));
}

TEST(ChartLayersTest, ThresholdsCrossThePlotIfTheyAreOnIt) {
  const auto lines =
      ThresholdsLayer(Plot(), {{50.0, false, ""}, {2.5, true, ""}, {11.0, true, ""}}, kRed, 1.0);
  ASSERT_EQ(DataOf(lines)->GetNumberOfLines(), 2);
  EXPECT_EQ(PointOf(lines, 0), Eigen::Vector2d(1.0, 22.0));
  EXPECT_EQ(PointOf(lines, 1), Eigen::Vector2d(21.0, 22.0));
  EXPECT_EQ(PointOf(lines, 2), Eigen::Vector2d(6.0, 2.0));
  EXPECT_EQ(PointOf(lines, 3), Eigen::Vector2d(6.0, 42.0));
}

TEST(ChartLayersTest, TheGridHasALineForEachTickAndAnOutline) {
  const auto grid = ChartGridLayer(Plot(), {{5.0, ""}}, {{25.0, ""}, {50.0, ""}}, kRed, 1.0);
  EXPECT_EQ(DataOf(grid)->GetNumberOfLines(), 4);
  EXPECT_EQ(PointOf(grid, 0), Eigen::Vector2d(11.0, 2.0));
  EXPECT_EQ(PointOf(grid, 2), Eigen::Vector2d(1.0, 12.0));
}

TEST(ChartLayersTest, SubjectsOfOneChartHaveColorsOfTheirOwn) {
  using S = ChartSubject;
  for (const Theme theme : {Theme::kDefault, Theme::kColorBlind}) {
    const auto differ = [&](const std::vector<S>& subjects) {
      for (const S a : subjects) {
        for (const S b : subjects) {
          if (a != b && ColorOf(a, PaletteOf(theme)) == ColorOf(b, PaletteOf(theme))) return false;
        }
      }
      return true;
    };
    EXPECT_TRUE(differ({S::kAccepted, S::kInconsistent, S::kAmbiguous, S::kBelowMinScore}));
    EXPECT_TRUE(differ({S::kWorst, S::kMean}));
    EXPECT_TRUE(differ({S::kBefore, S::kAfter}));
  }
}

}  // namespace
}  // namespace loopscope
