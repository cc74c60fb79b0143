// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/recording_charts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/graph/outliers.h"
#include "core/graph/spa_cost.h"
#include "core/grid/probability.h"
#include "core/slam/loop_explanation.h"
#include "core/slam/state.h"

namespace loopscope {
namespace {

struct SubjectOfVerdict {
  Verdict verdict;
  ChartSubject subject;
};

/// Those of searches; from the least to the most interesting.
constexpr SubjectOfVerdict kSearched[] = {{Verdict::kBelowMinScore, ChartSubject::kBelowMinScore},
                                          {Verdict::kInconsistent, ChartSubject::kInconsistent},
                                          {Verdict::kFromBehind, ChartSubject::kFromBehind},
                                          {Verdict::kAmbiguous, ChartSubject::kAmbiguous},
                                          {Verdict::kAccepted, ChartSubject::kAccepted}};

/// A loop and how far its node is from where it wants it [m].
struct LoopResidualNow {
  int candidate = 0;
  double residual = 0.0;
};

/// Of the loops in force: those that are outliers at these poses are left out.
std::vector<LoopResidualNow> ResidualsIn(const Recording& recording, int step,
                                         const std::vector<Pose2>& global_from_submap,
                                         const std::vector<Pose2>& global_from_node) {
  const OutlierOptions& options = recording.options().pose_graph.optimization_problem.outliers;
  std::vector<LoopResidualNow> residuals;
  const auto& candidates = recording.candidates();
  for (int i = 0; i < static_cast<int>(candidates.size()); ++i) {
    const LoopCandidate& loop = candidates[i];
    if (loop.verdict != Verdict::kAccepted || loop.applied_step > step) continue;
    const Eigen::Vector3d residual =
        SpaError(loop.submap_from_node, global_from_submap[loop.submap.index],
                 global_from_node[loop.node.index]);
    if (!IsOutlier(residual, options)) residuals.push_back({i, residual.head<2>().norm()});
  }
  return residuals;
}

double MeanOf(const std::vector<LoopResidualNow>& residuals) {
  double sum = 0.0;
  for (const LoopResidualNow& loop : residuals) sum += loop.residual;
  return residuals.empty() ? 0.0 : sum / static_cast<double>(residuals.size());
}

const LoopResidualNow& WorstOf(const std::vector<LoopResidualNow>& residuals) {
  return *std::max_element(residuals.begin(), residuals.end(),
                           [](const auto& a, const auto& b) { return a.residual < b.residual; });
}

/// With room for the points of the last step.
ChartAxis StepAxis(int step) { return {"step", 0.0, 1.02 * std::max(step, 10), false}; }

ChartAxis ScoreAxis() { return {"score", kMinProbability, kMaxProbability, false}; }

bool WasSearched(const LoopCandidate& candidate, int step) {
  return candidate.verdict != Verdict::kNotSampled && candidate.applied_step <= step;
}

bool IsIn(const LoopCandidate& candidate, Verdict verdict, int step) {
  return candidate.verdict == verdict && candidate.applied_step <= step;
}

bool HasPoints(const ChartData& data) {
  return std::any_of(data.series.begin(), data.series.end(),
                     [](const ChartSeries& series) { return !series.points.empty(); });
}

/// What the scores of the searches had to beat: it differs from submap to submap.
std::vector<ChartThreshold> MinScores(const Recording& recording, int step) {
  double least = kMaxProbability;
  double greatest = kMinProbability;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!WasSearched(candidate, step)) continue;
    least = std::min(least, candidate.min_score);
    greatest = std::max(greatest, candidate.min_score);
  }
  if (least > greatest) return {};
  if (least == greatest) return {{least, true, fmt::format("min_score {:.3g}", least)}};
  return {{least, true, fmt::format("least min_score {:.2f}", least)},
          {greatest, true, fmt::format("greatest min_score {:.2f}", greatest)}};
}

/// Whole tenths around 0 and all points.
ChartAxis MarginAxis(const std::vector<ChartSeries>& series) {
  double least = -0.1;
  double greatest = 0.1;
  for (const ChartSeries& each : series) {
    for (const ChartPoint& point : each.points) {
      least = std::min(least, point.y);
      greatest = std::max(greatest, point.y);
    }
  }
  return {"score - min_score", std::floor(10.0 * least) / 10.0, std::ceil(10.0 * greatest) / 10.0,
          false};
}

/// By how much scores beat what they had to beat, each its own: what is missing to a loop is seen,
/// and what was refused though it scored enough.
ChartData Scores(const Recording& recording, int step) {
  ChartData data{"Scores of loop searches", StepAxis(step), {}, {}, {}};
  const auto& candidates = recording.candidates();
  for (const SubjectOfVerdict& kind : kSearched) {
    ChartSeries series{kind.subject, ToString(kind.verdict), {}, false, {}};
    for (int i = 0; i < static_cast<int>(candidates.size()); ++i) {
      if (!IsIn(candidates[i], kind.verdict, step)) continue;
      series.points.push_back({static_cast<double>(candidates[i].considered_step),
                               candidates[i].score - candidates[i].min_score, i});
    }
    data.series.push_back(std::move(series));
  }
  data.y = MarginAxis(data.series);
  if (HasPoints(data)) data.thresholds = {{0.0, false, "min_score of the search"}};
  return data;
}

/// Bars of `counts` that stand on `base`, which grows by them; `edges` has one more.
std::vector<ChartBar> BarsOn(const std::vector<double>& edges, const std::vector<int>& counts,
                             std::vector<double>* base) {
  std::vector<ChartBar> bars;
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const double low = (*base)[i];
    (*base)[i] += counts[i];
    if (counts[i] > 0) bars.push_back({edges[i], edges[i + 1], low, (*base)[i]});
  }
  return bars;
}

/// The axis of counts up to a little above the highest bar.
ChartAxis CountAxis(const std::string& title, const std::vector<double>& tops) {
  const double top = tops.empty() ? 0.0 : *std::max_element(tops.begin(), tops.end());
  return {title, 0.0, 1.05 * std::max(1.0, top), false};
}

ChartData ScoreHistogram(const Recording& recording, int step) {
  constexpr int kNumBins = 40;
  ChartData data{"Scores of loop searches", ScoreAxis(), {}, {}, {}};
  const double width = (data.x.max - data.x.min) / kNumBins;
  std::vector<double> edges;
  for (int i = 0; i <= kNumBins; ++i) edges.push_back(data.x.min + i * width);
  std::vector<double> tops(kNumBins, 0.0);
  for (const SubjectOfVerdict& kind : kSearched) {
    std::vector<int> counts(kNumBins, 0);
    for (const LoopCandidate& candidate : recording.candidates()) {
      if (!IsIn(candidate, kind.verdict, step)) continue;
      const int bin = static_cast<int>(std::floor((candidate.score - data.x.min) / width));
      ++counts[std::clamp(bin, 0, kNumBins - 1)];
    }
    data.series.push_back(
        {kind.subject, ToString(kind.verdict), {}, false, BarsOn(edges, counts, &tops)});
  }
  data.y = CountAxis("searches", tops);
  data.thresholds = MinScores(recording, step);
  return data;
}

constexpr double kSmallestResidual = 1e-3;  // [m] that a chart tells from none

/// Whole powers of ten around 1 mm to `largest` [m].
ChartAxis ResidualAxis(double largest) {
  const double decades = std::ceil(std::log10(std::max(largest, 1e-2)) - 1e-9);
  return {"residual [m]", kSmallestResidual, std::pow(10.0, decades), true};
}

ChartData Residuals(const Recording& recording, int step) {
  ChartData data{"Residuals of loops in force after each optimization", StepAxis(step), {}, {}, {}};
  ChartSeries worst{ChartSubject::kWorst, "worst", {}, true, {}};
  ChartSeries mean{ChartSubject::kMean, "mean", {}, true, {}};
  double largest = 0.0;
  for (const Optimization& optimization : recording.optimizations()) {
    if (optimization.step > step) break;
    const auto residuals =
        ResidualsIn(recording, optimization.step, optimization.global_from_submap,
                    optimization.global_from_node);
    if (residuals.empty()) continue;
    const LoopResidualNow& top = WorstOf(residuals);
    const double x = optimization.step;
    worst.points.push_back({x, top.residual, top.candidate});
    mean.points.push_back({x, MeanOf(residuals), -1});
    largest = std::max(largest, top.residual);
  }
  data.y = ResidualAxis(largest);
  data.series = {mean, worst};
  return data;
}

ChartData ResidualHistogram(const Recording& recording, int step) {
  constexpr int kBinsPerDecade = 8;
  const MapState state = StateAfterStep(recording, step);
  const auto residuals =
      ResidualsIn(recording, step, state.global_from_submap, state.global_from_node);
  ChartData data{"Residuals of loops in force", {}, {}, {}, {}};
  data.x = ResidualAxis(residuals.empty() ? 0.0 : WorstOf(residuals).residual);
  const int num_bins =
      static_cast<int>(std::lround(kBinsPerDecade * std::log10(data.x.max / data.x.min)));
  std::vector<double> edges;
  for (int i = 0; i <= num_bins; ++i) {
    edges.push_back(data.x.min * std::pow(10.0, static_cast<double>(i) / kBinsPerDecade));
  }
  std::vector<int> counts(num_bins, 0);
  for (const LoopResidualNow& loop : residuals) {
    const int bin = static_cast<int>(std::floor(num_bins * data.x.PlaceOf(loop.residual)));
    ++counts[std::clamp(bin, 0, num_bins - 1)];
  }
  std::vector<double> tops(num_bins, 0.0);
  data.series = {{ChartSubject::kAccepted, "in force", {}, false, BarsOn(edges, counts, &tops)}};
  data.y = CountAxis("loops", tops);
  if (residuals.empty()) return data;
  data.thresholds = {{MeanOf(residuals), true, fmt::format("mean {:.2g} m", MeanOf(residuals))}};
  return data;
}

ChartData Costs(const Recording& recording, int step) {
  constexpr double kSmallestCost = 1.0;  // that the chart tells from none
  ChartData data{"Cost of optimizations", StepAxis(step), {}, {}, {}};
  ChartSeries before{ChartSubject::kBefore, "before", {}, true, {}};
  ChartSeries after{ChartSubject::kAfter, "after", {}, true, {}};
  double least = std::numeric_limits<double>::infinity();
  double most = 1.0;
  for (const Optimization& optimization : recording.optimizations()) {
    if (optimization.step > step) break;
    const double x = optimization.step;
    before.points.push_back({x, optimization.initial_cost, -1});
    after.points.push_back({x, optimization.final_cost, -1});
    least = std::min({least, optimization.initial_cost, optimization.final_cost});
    most = std::max({most, optimization.initial_cost, optimization.final_cost});
  }
  data.y = {"cost (eq. 4, without unit)",
            std::pow(10.0, std::floor(std::log10(std::clamp(least, kSmallestCost, most)))),
            std::pow(10.0, std::floor(std::log10(most)) + 1.0), true};
  data.series = {before, after};
  return data;
}

}  // namespace

ChartData ChartOf(const Recording& recording, ChartKind kind, int step) {
  switch (kind) {
    case ChartKind::kScores:
      return Scores(recording, step);
    case ChartKind::kScoreHistogram:
      return ScoreHistogram(recording, step);
    case ChartKind::kResiduals:
      return Residuals(recording, step);
    case ChartKind::kResidualHistogram:
      return ResidualHistogram(recording, step);
    case ChartKind::kCosts:
      break;
  }
  return Costs(recording, step);
}

}  // namespace loopscope
