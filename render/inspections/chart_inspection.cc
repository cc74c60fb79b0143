// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "core/slam/loop_explanation.h"
#include "render/charts/recording_charts.h"
#include "render/inspections/inspections.h"
#include "render/layout.h"
#include "render/number_text.h"
#include "render/views/chart_plot.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

struct ChartThings {
  ChartKind kind = ChartKind::kScores;
  ChartData data;
  ChartPlot plot;
  std::vector<LoopCandidate> candidates;
};

bool IsOfResiduals(ChartKind kind) {
  return kind == ChartKind::kResiduals || kind == ChartKind::kResidualHistogram;
}

std::string ValueText(ChartKind kind, double value) {
  return IsOfResiduals(kind) ? LengthText(value) : fmt::format("{:.4g}", value);
}

Finding FindingOf(const ChartThings& things, const ChartPoint& point) {
  Finding finding;
  finding.step = static_cast<int>(point.x);
  finding.facts = {{"step", std::to_string(*finding.step)},
                   {things.data.y.title, ValueText(things.kind, point.y)}};
  if (point.candidate < 0) return finding;
  const LoopCandidate& candidate = things.candidates[point.candidate];
  finding.loop = point.candidate;
  if (things.kind == ChartKind::kScores) {
    finding.facts.push_back({"score", fmt::format("{:.4g}", candidate.score)});
    finding.facts.push_back({"min_score", fmt::format("{:.4g}", candidate.min_score)});
  }
  finding.facts.push_back({"node", ToString(candidate.node)});
  finding.facts.push_back({"submap", ToString(candidate.submap)});
  finding.facts.push_back({"verdict", ToString(candidate.verdict)});
  return finding;
}

Finding FindingOf(const ChartThings& things, const ChartBar& bar) {
  const bool is_first = bar.begin <= things.data.x.min;  // holds all that is less
  Finding finding;
  finding.range = LoopRange{IsOfResiduals(things.kind) ? "residual" : "score",
                            is_first ? 0.0 : bar.begin, bar.end};
  finding.facts = {{"from", ValueText(things.kind, bar.begin)},
                   {"to", ValueText(things.kind, bar.end)},
                   {things.data.y.title, CountText(bar.high - bar.low)}};
  return finding;
}

std::optional<Finding> FindIn(const ChartThings& things, const Eigen::Vector2d& point) {
  const Eigen::Vector2d value = things.plot.ValueAt(point);
  if (const auto found = PointAt(things.data, value.x(), value.y())) {
    return FindingOf(things, *found);
  }
  if (const auto bar = BarAt(things.data, value.x(), value.y())) return FindingOf(things, *bar);
  return std::nullopt;
}

}  // namespace

Look InspectChart(const Recording& recording, const ViewRequest& request, const Scene& scene) {
  const Panel& panel = scene.panels.front();
  const SheetSize size =
      MakeSheetSize(request.width, request.height, scene.oversampling, request.text_height);
  auto things = std::make_shared<ChartThings>();
  things->kind = request.chart;
  things->data = ChartOf(recording, request.chart, StepOf(recording, request));
  things->plot = PlaceChart(things->data, panel.frame.width / panel.frame.height,
                            TextStyleOf(size, {}), panel.camera.meters_per_pixel)
                     .plot;
  things->candidates = recording.candidates();
  return [things](int, const Eigen::Vector2d& point, double) { return FindIn(*things, point); };
}

}  // namespace loopscope
