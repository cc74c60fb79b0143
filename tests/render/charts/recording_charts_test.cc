// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/recording_charts.h"

#include <numeric>

#include <gtest/gtest.h>

#include "core/slam/loop_explanation.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

class ChartOfTest : public testing::Test {
 protected:
  static const Recording& Run() {
    static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
    return recording;
  }
  static int LastStep() { return Run().num_steps() - 1; }

  static int NumSearched(int step) {
    const auto& candidates = Run().candidates();
    return static_cast<int>(
        std::count_if(candidates.begin(), candidates.end(), [&](const auto& candidate) {
          return candidate.verdict != Verdict::kNotSampled && candidate.applied_step <= step;
        }));
  }

  static double CountOf(const ChartData& data) {
    double count = 0.0;
    for (const ChartSeries& series : data.series) {
      for (const ChartBar& bar : series.bars) count += bar.high - bar.low;
    }
    return count;
  }
};

TEST_F(ChartOfTest, ScoresHaveAPointForEverySearchUntilTheStep) {
  for (const int step : {0, 150, LastStep()}) {
    const ChartData data = ChartOf(Run(), ChartKind::kScores, step);
    int count = 0;
    for (const ChartSeries& series : data.series) {
      for (const ChartPoint& point : series.points) {
        const LoopCandidate& candidate = Run().candidates()[point.candidate];
        EXPECT_EQ(point.x, candidate.considered_step);
        EXPECT_EQ(point.y, candidate.score - candidate.min_score);
        EXPECT_LE(data.y.min, point.y);
        EXPECT_GE(data.y.max, point.y);
        EXPECT_LT(point.x, data.x.max);
        EXPECT_EQ(point.y > 0.0, IsFound(candidate.verdict)) << point.candidate;
        EXPECT_EQ(candidate.verdict == Verdict::kAccepted,
                  series.subject == ChartSubject::kAccepted);
        ++count;
      }
    }
    EXPECT_EQ(count, NumSearched(step));
  }
  EXPECT_GT(NumSearched(LastStep()), NumSearched(150));
}

TEST_F(ChartOfTest, WhatScoresHadToBeatAreThresholds) {
  double least = 1.0;
  double greatest = 0.0;
  for (const LoopCandidate& candidate : Run().candidates()) {
    if (candidate.verdict == Verdict::kNotSampled) continue;
    least = std::min(least, candidate.min_score);
    greatest = std::max(greatest, candidate.min_score);
  }
  ASSERT_LT(least, greatest);
  const ChartData data = ChartOf(Run(), ChartKind::kScoreHistogram, LastStep());
  ASSERT_EQ(data.thresholds.size(), 2u);
  EXPECT_EQ(data.thresholds[0].value, least);
  EXPECT_EQ(data.thresholds[1].value, greatest);
  EXPECT_TRUE(data.thresholds[0].upright);
  ASSERT_EQ(ChartOf(Run(), ChartKind::kScores, LastStep()).thresholds.size(), 1u);
  EXPECT_EQ(ChartOf(Run(), ChartKind::kScores, LastStep()).thresholds[0].value, 0.0);
  for (const ChartKind kind : {ChartKind::kScores, ChartKind::kScoreHistogram}) {
    EXPECT_TRUE(ChartOf(Run(), kind, 0).thresholds.empty());
  }
}

TEST_F(ChartOfTest, TheHistogramOfScoresCountsEverySearchOnce) {
  const ChartData data = ChartOf(Run(), ChartKind::kScoreHistogram, LastStep());
  EXPECT_EQ(CountOf(data), NumSearched(LastStep()));
  for (const ChartSeries& series : data.series) {
    for (const ChartBar& bar : series.bars) EXPECT_LE(bar.high, data.y.max);
  }
}

TEST_F(ChartOfTest, BarsOfAHistogramStandOnEachOther) {
  const ChartData data = ChartOf(Run(), ChartKind::kScoreHistogram, LastStep());
  std::map<double, double> tops;  // by the beginning of the bar
  for (const ChartSeries& series : data.series) {
    for (const ChartBar& bar : series.bars) {
      EXPECT_EQ(bar.low, tops[bar.begin]);
      tops[bar.begin] = bar.high;
    }
  }
}

TEST_F(ChartOfTest, ResidualsAreThoseOfTheLoopsAfterEachOptimization) {
  const ChartData data = ChartOf(Run(), ChartKind::kResiduals, LastStep());
  ASSERT_EQ(data.series.size(), 2u);
  const ChartSeries& worst = data.series[1];
  ASSERT_EQ(worst.subject, ChartSubject::kWorst);
  ASSERT_FALSE(worst.points.empty());
  const ChartPoint& last = worst.points.back();
  const MapState state = StateAfterStep(Run(), LastStep());
  double largest = 0.0;
  for (const LoopCandidate& candidate : Run().candidates()) {
    if (candidate.verdict != Verdict::kAccepted) continue;
    largest = std::max(largest, LoopResidual(state, candidate).head<2>().norm());
  }
  EXPECT_NEAR(last.y, largest, 1e-9);
  EXPECT_NEAR(LoopResidual(state, Run().candidates()[last.candidate]).head<2>().norm(), largest,
              1e-9);
  EXPECT_LE(data.series[0].points.back().y, largest);
  EXPECT_TRUE(data.y.logarithmic);
  EXPECT_GE(data.y.max, largest);
}

TEST_F(ChartOfTest, ResidualsLeaveOutliersOut) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimization_problem.outliers.max_distance = 0.002;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  const int last = recording.num_steps() - 1;
  for (const ChartSeries& series : ChartOf(recording, ChartKind::kResiduals, last).series) {
    for (const ChartPoint& point : series.points) EXPECT_LE(point.y, 0.002);
  }
  const double num_held = CountOf(ChartOf(recording, ChartKind::kResidualHistogram, last));
  const auto& candidates = recording.candidates();
  const auto num_loops = std::count_if(candidates.begin(), candidates.end(), [](const auto& c) {
    return c.verdict == Verdict::kAccepted;
  });
  EXPECT_GT(num_held, 0.0);
  EXPECT_LT(num_held, num_loops);
}

TEST_F(ChartOfTest, TheHistogramOfResidualsCountsTheLoopsUntilTheStep) {
  for (const int step : {0, 180, LastStep()}) {
    int num_loops = 0;
    for (const LoopCandidate& candidate : Run().candidates()) {
      num_loops += candidate.verdict == Verdict::kAccepted && candidate.applied_step <= step;
    }
    const ChartData data = ChartOf(Run(), ChartKind::kResidualHistogram, step);
    EXPECT_EQ(CountOf(data), num_loops) << step;
    EXPECT_EQ(data.thresholds.empty(), num_loops == 0);
  }
}

TEST_F(ChartOfTest, CostsAreThoseOfEachOptimizationUntilTheStep) {
  const ChartData data = ChartOf(Run(), ChartKind::kCosts, LastStep());
  const auto& optimizations = Run().optimizations();
  for (std::size_t i = 0; i < optimizations.size(); ++i) {
    EXPECT_EQ(data.series[0].points.at(i).x, optimizations[i].step);
    EXPECT_EQ(data.series[0].points[i].y, optimizations[i].initial_cost);
    EXPECT_EQ(data.series[1].points.at(i).y, optimizations[i].final_cost);
    EXPECT_LE(optimizations[i].final_cost, optimizations[i].initial_cost);
  }
  const int first = optimizations.front().step;
  EXPECT_EQ(ChartOf(Run(), ChartKind::kCosts, first).series[0].points.size(), 1u);
  EXPECT_TRUE(ChartOf(Run(), ChartKind::kCosts, first - 1).series[0].points.empty());
}

}  // namespace
}  // namespace loopscope
