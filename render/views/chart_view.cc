// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "render/charts/recording_charts.h"
#include "render/layers/outline.h"
#include "render/number_text.h"
#include "render/views/chart_plot.h"
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

/// The candidates that are selected or marked.
std::set<int> MarkedCandidates(const Recording& recording, const ViewRequest& request) {
  std::vector<LoopPair> pairs = request.marked;
  if (request.node && request.submap) pairs.push_back({*request.node, *request.submap});
  std::set<int> candidates;
  for (const LoopPair& pair : pairs) {
    if (const auto index = recording.FindCandidate(pair.submap, pair.node)) {
      candidates.insert(*index);
    }
  }
  return candidates;
}

/// A ring around each point that stands for one of `candidates`.
void DrawMarks(const ChartData& data, const ChartPlot& plot, const std::set<int>& candidates,
               Sheet* sheet) {
  const double radius = sheet->Meters(0, 0.7 * widths::kMark);
  for (const ChartSeries& series : data.series) {
    for (const ChartPoint& point : series.points) {
      if (candidates.count(point.candidate) == 0) continue;
      sheet->Add(0, LayerKind::kSelection, [&] {
        return CircleLayer(plot.At(point.x, point.y), radius, sheet->palette().selection,
                           sheet->Px(widths::kBold));
      });
    }
  }
}

void DrawChart(const ChartData& data, const std::set<int>& marked, double width, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  const TextStyle style = TextStyleOf(sheet->size(), palette.faint_ink);
  const double pixel = sheet->camera(0).meters_per_pixel;
  const PlacedChart chart = PlaceChart(data, width, style, pixel);
  const ChartPlot& plot = chart.plot;
  sheet->Add(0, LayerKind::kGrid, [&] {
    return ChartGridLayer(plot, chart.x_ticks, chart.y_ticks, palette.rule,
                          sheet->Px(widths::kThin));
  });
  for (const ChartSeries& series : data.series) {
    sheet->Add(0, LayerKind::kScan, [&] {
      const double size = sheet->Px(series.joined ? 1.6 * widths::kNode : 1.2 * widths::kNode);
      return ChartSeriesLayer(plot, series, ColorOf(series.subject, palette),
                              {sheet->Px(widths::kLine), size, true});
    });
  }
  DrawMarks(data, plot, marked, sheet);
  sheet->Add(0, LayerKind::kLabels, [&] {
    return ThresholdsLayer(plot, data.thresholds, palette.ink, sheet->Px(widths::kLine));
  });
  for (const auto& texts : ChartTexts(plot, data, chart.x_ticks, chart.y_ticks, style,
                                      WithOpacity(palette.paper, 0.8), pixel)) {
    sheet->Add(0, LayerKind::kLabels, [&] { return texts; });
  }
}

}  // namespace

Scene BuildChartView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const int step = StepOf(recording, request);
  const ChartData data = ChartOf(recording, request.chart, step);
  Sheet sheet(request, oversampling, Describe(recording, data, step),
              KeysOf(data, PaletteOf(request.theme)));
  DrawChart(data, MarkedCandidates(recording, request), sheet.OpenChart(0, {}), &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
