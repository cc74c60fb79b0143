// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "render/charts/recording_charts.h"
#include "render/layers/chart_layers.h"
#include "render/views/grids.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

bool HasContent(const ChartSeries& series) {
  return !series.points.empty() || !series.bars.empty();
}

LayerKeys KeysOf(const ChartData& data, const Palette& palette) {
  LayerKeys keys;
  for (const ChartSeries& series : data.series) {
    if (!HasContent(series)) continue;
    const Swatch::Kind kind = !series.bars.empty() ? Swatch::Kind::kFill
                              : series.joined      ? Swatch::Kind::kLine
                                                   : Swatch::Kind::kPoint;
    keys.legend.push_back(
        {LayerKind::kScan, {{kind, ColorOf(series.subject, palette), palette.paper}, series.name}});
  }
  return keys;
}

/// How much a series holds.
Fact FactOf(const ChartSeries& series) {
  double count = static_cast<double>(series.points.size());
  for (const ChartBar& bar : series.bars) count += bar.high - bar.low;
  return {series.name, CountText(count)};
}

Annotation Describe(const Recording& recording, const ChartData& data, int step) {
  Annotation annotation;
  annotation.title = data.title;
  annotation.subtitle = Subtitle(recording, step, {});
  for (const ChartSeries& series : data.series) {
    if (!series.joined && HasContent(series)) annotation.facts.push_back(FactOf(series));
  }
  if (std::none_of(data.series.begin(), data.series.end(), HasContent)) {
    annotation.facts.push_back({"until now", "nothing"});
  }
  return annotation;
}

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

void DrawChart(const ChartData& data, double width, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  const TextStyle style = TextStyleOf(sheet->size(), palette.faint_ink);
  const double pixel = sheet->camera(0).meters_per_pixel;
  const double em = style.size * pixel;
  const auto y_ticks = TicksOf(data.y, NumTicks(1.0, 4.0 * em));
  const ChartPlot plot{PlotBox(width, y_ticks, style, pixel), data.x, data.y};
  const auto x_ticks = TicksOf(data.x, NumTicks(width, 6.0 * em));
  sheet->Add(0, LayerKind::kGrid, [&] {
    return ChartGridLayer(plot, x_ticks, y_ticks, palette.rule, sheet->Px(widths::kThin));
  });
  for (const ChartSeries& series : data.series) {
    sheet->Add(0, LayerKind::kScan, [&] {
      const double size = sheet->Px(series.joined ? 1.6 * widths::kNode : 1.2 * widths::kNode);
      return ChartSeriesLayer(plot, series, ColorOf(series.subject, palette),
                              {sheet->Px(widths::kLine), size, true});
    });
  }
  sheet->Add(0, LayerKind::kLabels, [&] {
    return ThresholdsLayer(plot, data.thresholds, palette.ink, sheet->Px(widths::kLine));
  });
  for (const auto& texts :
       ChartTexts(plot, data, x_ticks, y_ticks, style, WithOpacity(palette.paper, 0.8), pixel)) {
    sheet->Add(0, LayerKind::kLabels, [&] { return texts; });
  }
}

}  // namespace

Scene BuildChartView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const int step = StepOf(recording, request);
  const ChartData data = ChartOf(recording, request.chart, step);
  Sheet sheet(request, oversampling, Describe(recording, data, step),
              KeysOf(data, PaletteOf(request.theme)));
  DrawChart(data, sheet.OpenChart(0, {}), &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
