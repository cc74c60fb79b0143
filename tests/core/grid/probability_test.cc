// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/probability.h"

#include <algorithm>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr double kStep = (kMaxProbability - kMinProbability) / (kMaxCellValue - 1);

/// clamp(odds^-1(odds(M_old) odds(p))) of eq. 3, written out.
double UpdatedByEquation3(double old_probability, double p) {
  const double odds = old_probability / (1.0 - old_probability) * (p / (1.0 - p));
  return std::clamp(odds / (1.0 + odds), 0.1, 0.9);
}

TEST(Odds, AreThoseOfEquation2) {
  EXPECT_DOUBLE_EQ(Odds(0.5), 1.0);
  EXPECT_DOUBLE_EQ(Odds(0.8), 4.0);
  EXPECT_DOUBLE_EQ(ProbabilityFromOdds(4.0), 0.8);
}

TEST(CellValue, RunsFromTheLeastToTheGreatestProbability) {
  EXPECT_DOUBLE_EQ(ProbabilityOf(1), 0.1);
  EXPECT_DOUBLE_EQ(ProbabilityOf(kMaxCellValue), 0.9);
  EXPECT_DOUBLE_EQ(ProbabilityOf(2) - ProbabilityOf(1), kStep);
}

TEST(CellValue, SurvivesTheWayOverItsProbability) {
  for (int value = 1; value <= kMaxCellValue; ++value) {
    EXPECT_EQ(ToCellValue(ProbabilityOf(static_cast<CellValue>(value))), value);
  }
}

TEST(CellValue, IsNearestToItsProbability) {
  EXPECT_EQ(ToCellValue(0.1 + 100.4 * kStep), 101);
  EXPECT_EQ(ToCellValue(0.1 + 100.6 * kStep), 102);
}

TEST(CellValue, IsClampedAndNeverUnknown) {
  EXPECT_EQ(ToCellValue(0.0), 1);
  EXPECT_EQ(ToCellValue(0.05), 1);
  EXPECT_EQ(ToCellValue(0.95), kMaxCellValue);
  EXPECT_EQ(ToCellValue(1.0), kMaxCellValue);
}

TEST(OddsUpdate, FollowsEquation3ForEveryValue) {
  for (const double p : {0.12, 0.4, 0.49, 0.55, 0.7, 0.88}) {
    const OddsUpdate update(p);
    for (int value = 1; value <= kMaxCellValue; ++value) {
      const auto old_value = static_cast<CellValue>(value);
      const double expected = UpdatedByEquation3(ProbabilityOf(old_value), p);
      ASSERT_NEAR(ProbabilityOf(update(old_value)), expected, 0.5 * kStep + 1e-12)
          << "value " << value << " observed with " << p;
    }
  }
}

TEST(OddsUpdate, GivesAnUnknownCellTheProbabilityOfTheObservation) {
  EXPECT_NEAR(ProbabilityOf(OddsUpdate(0.55)(kUnknown)), 0.55, 0.5 * kStep + 1e-12);
  EXPECT_NEAR(ProbabilityOf(OddsUpdate(0.49)(kUnknown)), 0.49, 0.5 * kStep + 1e-12);
}

TEST(OddsUpdate, EndsAtTheClampsWhenRepeated) {
  const OddsUpdate hit(0.55);
  const OddsUpdate miss(0.49);
  CellValue occupied = kUnknown;
  CellValue free = kUnknown;
  for (int i = 0; i < 100; ++i) {
    occupied = hit(occupied);
    free = miss(free);
  }
  EXPECT_EQ(occupied, kMaxCellValue);
  EXPECT_EQ(free, 1);
}

}  // namespace
}  // namespace loopscope
