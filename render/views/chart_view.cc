// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "render/charts/recording_charts.h"
#include "render/number_text.h"
#include "render/views/chart_drawing.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

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

/// The candidates of `step` that are selected or marked.
std::set<int> MarkedCandidates(const Recording& recording, int step, const ViewRequest& request) {
  const int num_candidates = NumCandidatesAfterStep(recording, step);
  std::vector<LoopPair> pairs = request.marked;
  if (request.node && request.submap) pairs.push_back({*request.node, *request.submap});
  std::set<int> candidates;
  for (const LoopPair& pair : pairs) {
    const auto index = recording.FindCandidate(pair.submap, pair.node, num_candidates);
    if (index) candidates.insert(*index);
  }
  return candidates;
}

}  // namespace

Scene BuildChartView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const int step = StepOf(recording, request);
  const ChartData data = ChartOf(recording, request.chart, step);
  Sheet sheet(request, oversampling, Describe(recording, data, step),
              KeysOf({&data}, PaletteOf(request.theme)));
  DrawChart(data, 0, sheet.OpenChart(0, {}), &sheet, MarkedCandidates(recording, step, request));
  return sheet.Finish();
}

}  // namespace loopscope
