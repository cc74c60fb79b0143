// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loopscope {

Statistics StatisticsOf(std::vector<double> values) {
  Statistics statistics;
  if (values.empty()) return statistics;
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  statistics.count = static_cast<int>(n);
  statistics.min = values.front();
  statistics.max = values.back();
  statistics.median = (values[(n - 1) / 2] + values[n / 2]) / 2.0;
  statistics.mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(n);
  double sum_of_squares = 0.0;
  double sum_of_squared_deviations = 0.0;
  for (const double value : values) {
    const double deviation = value - statistics.mean;
    sum_of_squares += value * value;
    sum_of_squared_deviations += deviation * deviation;
  }
  statistics.rmse = std::sqrt(sum_of_squares / static_cast<double>(n));
  if (n > 1) {
    statistics.standard_deviation =
        std::sqrt(sum_of_squared_deviations / static_cast<double>(n - 1));
  }
  return statistics;
}

double PopulationDeviation(const Statistics& statistics) {
  if (statistics.count < 2) return 0.0;
  const auto n = static_cast<double>(statistics.count);
  return statistics.standard_deviation * std::sqrt((n - 1.0) / n);
}

}  // namespace loopscope
