// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/chart_drawing.h"

#include <algorithm>

#include "render/charts/chart_ticks.h"
#include "render/layers/chart_layers.h"

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

void DrawChart(const ChartData& data, int panel, double width, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  const TextStyle style = TextStyleOf(sheet->size(), palette.faint_ink);
  const double pixel = sheet->camera(panel).meters_per_pixel;
  const double em = style.size * pixel;
  const auto y_ticks = TicksOf(data.y, NumTicks(1.0, 4.0 * em));
  const ChartPlot plot{PlotBox(width, y_ticks, style, pixel), data.x, data.y};
  const auto x_ticks = TicksOf(data.x, NumTicks(width, 6.0 * em));
  sheet->Add(panel, LayerKind::kGrid, [&] {
    return ChartGridLayer(plot, x_ticks, y_ticks, palette.rule, sheet->Px(widths::kThin));
  });
  for (const ChartSeries& series : data.series) {
    sheet->Add(panel, LayerKind::kScan, [&] {
      const double size = sheet->Px(series.joined ? 1.6 * widths::kNode : 1.2 * widths::kNode);
      return ChartSeriesLayer(plot, series, ColorOf(series.subject, palette),
                              {sheet->Px(widths::kLine), size, true});
    });
  }
  sheet->Add(panel, LayerKind::kLabels, [&] {
    return ThresholdsLayer(plot, data.thresholds, palette.ink, sheet->Px(widths::kLine));
  });
  for (const auto& texts :
       ChartTexts(plot, data, x_ticks, y_ticks, style, WithOpacity(palette.paper, 0.8), pixel)) {
    sheet->Add(panel, LayerKind::kLabels, [&] { return texts; });
  }
}

}  // namespace loopscope
