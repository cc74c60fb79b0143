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

TEST(CandidateAtTest, IsTheNearestOneWithinReach) {
  const ChartData data = TwoPoints();
  EXPECT_EQ(CandidateAt(data, 50.1, 10.0), 7);
  EXPECT_EQ(CandidateAt(data, 50.8, 10.0), 8);
  EXPECT_EQ(CandidateAt(data, 49.0, 10.3), 7);
}

TEST(CandidateAtTest, IsNoneFarFromAllPoints) {
  const ChartData data = TwoPoints();
  EXPECT_EQ(CandidateAt(data, 47.0, 10.0), std::nullopt);
  EXPECT_EQ(CandidateAt(data, 50.0, 14.0), std::nullopt);
  EXPECT_EQ(CandidateAt(ChartData(), 0.5, 0.5), std::nullopt);
}

}  // namespace
}  // namespace loopscope
