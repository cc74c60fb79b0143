// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "render/layers/chart_layers.h"

namespace loopscope {

/// Where a chart stands in its panel, with its ticks.
struct PlacedChart {
  ChartPlot plot;
  std::vector<ChartTick> x_ticks;
  std::vector<ChartTick> y_ticks;
};

/// The chart in a panel that shows [0, width] x [0, 1], with as many ticks as have room, beside
/// what its numbers and titles take. `pixel` is the length of one in the panel.
PlacedChart PlaceChart(const ChartData& data, double width, const TextStyle& style, double pixel);

}  // namespace loopscope
