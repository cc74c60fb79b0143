// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/chart_data.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

/// x from 0 to 100, y from 1 to 100 in decades; candidate 7 at (50, 10), 8 at (51, 10).
ChartData TwoPoints() {
  ChartData data;
  data.x = {"step", 0.0, 100.0, false};
  data.y = {"cost", 1.0, 100.0, true};
  ChartSeries nobody;
  nobody.points = {{50.1, 10.0, -1}};
  ChartSeries loops;
  loops.points = {{50.0, 10.0, 7}, {51.0, 10.0, 8}};
  data.series = {loops, nobody};
  return data;
}

TEST(ChartKindTest, NamesLeadBackToTheirKinds) {
  for (const ChartKind kind :
       {ChartKind::kScores, ChartKind::kScoreHistogram, ChartKind::kResiduals,
        ChartKind::kResidualHistogram, ChartKind::kCosts}) {
    EXPECT_EQ(ChartKindFromName(ToString(kind)), kind);
  }
  EXPECT_EQ(MessageOf([] { ChartKindFromName("pie"); }),
            "unknown chart 'pie': expected one of scores, score-histogram, residuals, "
            "residual-histogram, costs");
}

TEST(ChartAxisTest, PlacesValuesEvenlyOrByTheirLogarithm) {
  const ChartAxis even{"", 2.0, 4.0, false};
  EXPECT_DOUBLE_EQ(even.PlaceOf(2.5), 0.25);
  EXPECT_DOUBLE_EQ(even.PlaceOf(1.0), 0.0);
  const ChartAxis decades{"", 0.01, 100.0, true};
  EXPECT_DOUBLE_EQ(decades.PlaceOf(1.0), 0.5);
  EXPECT_DOUBLE_EQ(decades.PlaceOf(0.0), 0.0);
}

TEST(ChartAxisTest, GivesBackTheValueOfAPlace) {
  for (const bool logarithmic : {false, true}) {
    const ChartAxis axis{"", 0.01, 100.0, logarithmic};
    for (const double value : {0.01, 0.3, 42.0}) {
      EXPECT_NEAR(axis.ValueAt(axis.PlaceOf(value)), value, 1e-9);
    }
  }
}

TEST(PointAtTest, IsTheNearestOneWithinReach) {
  const ChartData data = TwoPoints();
  EXPECT_EQ(PointAt(data, 50.1, 10.0)->candidate, -1);
  EXPECT_EQ(PointAt(data, 50.8, 10.0)->candidate, 8);
  EXPECT_EQ(PointAt(data, 49.0, 10.3)->candidate, 7);
}

TEST(PointAtTest, IsNoneFarFromAllPoints) {
  const ChartData data = TwoPoints();
  EXPECT_FALSE(PointAt(data, 47.0, 10.0).has_value());
  EXPECT_FALSE(PointAt(data, 50.0, 14.0).has_value());
  EXPECT_FALSE(PointAt(ChartData(), 0.5, 0.5).has_value());
}

TEST(BarAtTest, IsTheOneOfAPileUnderThePoint) {
  ChartData data;
  ChartSeries lower, upper;
  lower.bars = {{0.0, 1.0, 0.0, 2.0}};
  upper.bars = {{0.0, 1.0, 2.0, 5.0}};
  data.series = {lower, upper};
  EXPECT_EQ(BarAt(data, 0.5, 1.0)->high, 2.0);
  EXPECT_EQ(BarAt(data, 0.5, 4.0)->high, 5.0);
  EXPECT_FALSE(BarAt(data, 0.5, 6.0).has_value());
  EXPECT_FALSE(BarAt(data, 1.5, 1.0).has_value());
}

}  // namespace
}  // namespace loopscope
