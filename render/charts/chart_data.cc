// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/chart_data.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace loopscope {
namespace {

const std::vector<std::pair<ChartKind, std::string>>& Names() {
  static const std::vector<std::pair<ChartKind, std::string>> names{
      {ChartKind::kScores, "scores"},
      {ChartKind::kScoreHistogram, "score-histogram"},
      {ChartKind::kResiduals, "residuals"},
      {ChartKind::kResidualHistogram, "residual-histogram"},
      {ChartKind::kCosts, "costs"}};
  return names;
}

}  // namespace

ChartKind ChartKindFromName(const std::string& name) {
  std::string expected;
  for (const auto& [kind, known] : Names()) {
    if (known == name) return kind;
    expected += (expected.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument("unknown chart '" + name + "': expected one of " + expected);
}

std::string ToString(ChartKind kind) {
  const auto found = std::find_if(Names().begin(), Names().end(),
                                  [&](const auto& entry) { return entry.first == kind; });
  return found->second;
}

double ChartAxis::PlaceOf(double value) const {
  if (!logarithmic) return std::max(0.0, (value - min) / (max - min));
  return std::log(std::max(value, min) / min) / std::log(max / min);
}

std::optional<int> CandidateAt(const ChartData& data, double x, double y) {
  constexpr double kReach = 0.02;  // of an axis
  std::optional<int> nearest;
  double nearest_distance = kReach;
  for (const ChartSeries& series : data.series) {
    for (const ChartPoint& point : series.points) {
      if (point.candidate < 0) continue;
      const double distance = std::hypot(data.x.PlaceOf(point.x) - data.x.PlaceOf(x),
                                         data.y.PlaceOf(point.y) - data.y.PlaceOf(y));
      if (distance > nearest_distance) continue;
      nearest = point.candidate;
      nearest_distance = distance;
    }
  }
  return nearest;
}

}  // namespace loopscope
