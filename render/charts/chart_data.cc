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

double ChartAxis::ValueAt(double place) const {
  return logarithmic ? min * std::pow(max / min, place) : min + place * (max - min);
}

std::optional<ChartPoint> PointAt(const ChartData& data, double x, double y) {
  constexpr double kReach = 0.02;  // of an axis
  std::optional<ChartPoint> nearest;
  double nearest_distance = kReach;
  for (const ChartSeries& series : data.series) {
    for (const ChartPoint& point : series.points) {
      const double distance = std::hypot(data.x.PlaceOf(point.x) - data.x.PlaceOf(x),
                                         data.y.PlaceOf(point.y) - data.y.PlaceOf(y));
      if (distance > nearest_distance) continue;
      nearest = point;
      nearest_distance = distance;
    }
  }
  return nearest;
}

std::optional<ChartBar> BarAt(const ChartData& data, double x, double y) {
  for (const ChartSeries& series : data.series) {
    for (const ChartBar& bar : series.bars) {
      if (bar.begin <= x && x < bar.end && bar.low <= y && y <= bar.high) return bar;
    }
  }
  return std::nullopt;
}

}  // namespace loopscope
