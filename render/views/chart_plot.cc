// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/chart_plot.h"

#include <algorithm>

namespace loopscope {
namespace {

/// The part of the panel that its numbers and titles leave.
Box PlotBox(double width, const std::vector<ChartTick>& y_ticks, const TextStyle& style,
            double pixel) {
  double numbers = 0.0;
  for (const ChartTick& tick : y_ticks) numbers = std::max(numbers, TextWidth(tick.label, style));
  const double em = style.size * pixel;
  Box box{0.0, 0.0, width, 1.0};
  CutLeft(numbers * pixel + 0.8 * em, &box);
  CutRight(1.5 * em, &box);
  CutTop(2.0 * em, &box);
  CutBottom(3.1 * em, &box);
  return box;
}

/// As many ticks as have room along `length`, each `width` long.
int NumTicks(double length, double width) {
  return std::clamp(static_cast<int>(length / width), 1, 8);
}

}  // namespace

PlacedChart PlaceChart(const ChartData& data, double width, const TextStyle& style, double pixel) {
  const double em = style.size * pixel;
  const auto y_ticks = TicksOf(data.y, NumTicks(1.0, 4.0 * em));
  return {{PlotBox(width, y_ticks, style, pixel), data.x, data.y},
          TicksOf(data.x, NumTicks(width, 6.0 * em)),
          y_ticks};
}

}  // namespace loopscope
