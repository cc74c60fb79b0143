// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/error_histogram.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace loopscope {
namespace {

double RootMeanSquare(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return values.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(values.size()));
}

}  // namespace

double ErrorScaleOf(std::vector<double> values) {
  if (values.empty()) return 1.0;
  std::sort(values.begin(), values.end());
  const double most = values[(values.size() - 1) * 19 / 20];
  if (!(most > 0.0)) return 1.0;
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (most <= factor * power) return factor * power;
  }
  return 10.0 * power;
}

ChartData ErrorHistogram(const std::string& title, const std::vector<double>& values, double max) {
  constexpr int kNumBins = 40;
  std::vector<int> counts(kNumBins, 0);
  for (const double value : values) {
    ++counts[static_cast<int>(std::clamp(kNumBins * value / max, 0.0, kNumBins - 1.0))];
  }
  ChartSeries series{ChartSubject::kMean, "poses", {}, false, {}};
  int highest = 1;
  for (int i = 0; i < kNumBins; ++i) {
    if (counts[i] == 0) continue;
    series.bars.push_back(
        {i * max / kNumBins, (i + 1) * max / kNumBins, 0.0, static_cast<double>(counts[i])});
    highest = std::max(highest, counts[i]);
  }
  const double rmse = RootMeanSquare(values);
  return {title,
          {title, 0.0, max, false},
          {"count", 0.0, static_cast<double>(highest), false},
          {series},
          {{rmse, true, fmt::format("rmse {:.3g}", rmse)}}};
}

}  // namespace loopscope
