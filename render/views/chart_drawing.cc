// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/chart_drawing.h"

#include "render/layers/chart_layers.h"
#include "render/layers/outline.h"
#include "render/views/chart_plot.h"

namespace loopscope {
namespace {

/// A ring around each point that stands for one of `candidates`.
void DrawMarks(const ChartData& data, const ChartPlot& plot, const std::set<int>& candidates,
               int panel, Sheet* sheet) {
  const double radius = sheet->Meters(panel, 0.7 * widths::kMark);
  for (const ChartSeries& series : data.series) {
    for (const ChartPoint& point : series.points) {
      if (candidates.count(point.candidate) == 0) continue;
      sheet->Add(panel, LayerKind::kSelection, [&] {
        return CircleLayer(plot.At(point.x, point.y), radius, sheet->palette().selection,
                           sheet->Px(widths::kBold));
      });
    }
  }
}

}  // namespace

bool HasContent(const ChartSeries& series) {
  return !series.points.empty() || !series.bars.empty();
}

LayerKeys KeysOf(const std::vector<const ChartData*>& charts, const Palette& palette) {
  LayerKeys keys;
  for (const ChartData* chart : charts) {
    for (const ChartSeries& series : chart->series) {
      if (!HasContent(series)) continue;
      const Swatch::Kind kind = !series.bars.empty() ? Swatch::Kind::kFill
                                : series.joined      ? Swatch::Kind::kLine
                                                     : Swatch::Kind::kPoint;
      keys.legend.push_back(
          {LayerKind::kScan,
           {{kind, ColorOf(series.subject, palette), palette.paper}, series.name}});
    }
  }
  return keys;
}

void DrawChart(const ChartData& data, int panel, double width, Sheet* sheet,
               const std::set<int>& marked) {
  const Palette& palette = sheet->palette();
  const TextStyle style = TextStyleOf(sheet->size(), palette.faint_ink);
  const double pixel = sheet->camera(panel).meters_per_pixel;
  const PlacedChart chart = PlaceChart(data, width, style, pixel);
  const ChartPlot& plot = chart.plot;
  sheet->Add(panel, LayerKind::kGrid, [&] {
    return ChartGridLayer(plot, chart.x_ticks, chart.y_ticks, palette.rule,
                          sheet->Px(widths::kThin));
  });
  for (const ChartSeries& series : data.series) {
    sheet->Add(panel, LayerKind::kScan, [&] {
      const double size = sheet->Px(series.joined ? 1.6 * widths::kNode : 1.2 * widths::kNode);
      return ChartSeriesLayer(plot, series, ColorOf(series.subject, palette),
                              {sheet->Px(widths::kLine), size, true});
    });
  }
  DrawMarks(data, plot, marked, panel, sheet);
  sheet->Add(panel, LayerKind::kLabels, [&] {
    return ThresholdsLayer(plot, data.thresholds, palette.ink, sheet->Px(widths::kLine));
  });
  for (const auto& texts : ChartTexts(plot, data, chart.x_ticks, chart.y_ticks, style,
                                      WithOpacity(palette.paper, 0.8), pixel)) {
    sheet->Add(panel, LayerKind::kLabels, [&] { return texts; });
  }
}

}  // namespace loopscope
