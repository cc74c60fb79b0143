// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/chart_ticks.h"

#include <cmath>

#include <fmt/format.h>

#include "render/scale_bar.h"

namespace loopscope {
namespace {

constexpr double kSlack = 1e-9;  // of a step, for rounding

}  // namespace

std::vector<ChartTick> TicksOf(const ChartAxis& axis, int count) {
  std::vector<ChartTick> ticks;
  const double step = axis.logarithmic ? 1.0 : RoundLength((axis.max - axis.min) / count);
  const double low = axis.logarithmic ? std::log10(axis.min) : axis.min / step;
  const double high = axis.logarithmic ? std::log10(axis.max) : axis.max / step;
  for (double i = std::ceil(low - kSlack); i <= high + kSlack; ++i) {
    const double value = axis.logarithmic ? std::pow(10.0, i) : i * step + 0.0;  // no -0
    ticks.push_back({value, fmt::format("{:.6g}", value)});
  }
  return ticks;
}

}  // namespace loopscope
