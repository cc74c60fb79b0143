// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "render/layers/constraints.h"
#include "render/views/grids.h"
#include "render/views/pose_layers.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

/// The pose graph after a step.
struct Graph {
  MapState state;
  std::vector<PlacedConstraint> intra;
  std::vector<PlacedConstraint> inter;
};

Graph GraphAfterStep(const Recording& recording, int step) {
  Graph graph{StateAfterStep(recording, step), {}, {}};
  const std::vector<Constraint> constraints = ConstraintsOf(recording, graph.state);
  graph.intra = PlaceConstraints(constraints, Constraint::Tag::kIntraSubmap, graph.state);
  graph.inter = PlaceConstraints(constraints, Constraint::Tag::kInterSubmap, graph.state);
  return graph;
}

double MeanResidual(const std::vector<PlacedConstraint>& constraints) {
  double sum = 0.0;
  for (const PlacedConstraint& constraint : constraints) sum += constraint.residual();
  return sum / static_cast<double>(constraints.size());
}

std::vector<Fact> FactsOf(const Graph& graph) {
  std::vector<Fact> facts{{"nodes", fmt::format("{}", graph.state.num_nodes)},
                          {"submaps", fmt::format("{}", graph.state.num_submaps)},
                          {"INTRA", fmt::format("{}", graph.intra.size())},
                          {"INTER", fmt::format("{}", graph.inter.size())},
                          {"optimizations", fmt::format("{}", graph.state.num_optimizations)}};
  if (!graph.inter.empty()) {
    const auto worst =
        std::max_element(graph.inter.begin(), graph.inter.end(),
                         [](const auto& a, const auto& b) { return a.residual() < b.residual(); });
    facts.push_back({"mean residual", LengthText(MeanResidual(graph.inter))});
    facts.push_back({"worst residual", LengthText(worst->residual())});
    facts.push_back({"of node", ToString(worst->constraint.node)});
    facts.push_back({"in submap", ToString(worst->constraint.submap)});
  }
  return facts;
}

Annotation Describe(const Recording& recording, const Graph& graph, const MapColors& colors,
                    const Palette& palette) {
  Annotation annotation;
  annotation.title = "Pose graph";
  annotation.subtitle = Subtitle(recording, graph.state.step, {});
  annotation.legend = {
      {{Swatch::Kind::kLine, palette.inter, colors.unknown}, "INTER constraint"},
      {{Swatch::Kind::kLine, palette.inter_residual, colors.unknown}, "INTER residual"},
      {{Swatch::Kind::kLine, HueOf(1), colors.unknown}, "INTRA constraint, by submap"},
      {{Swatch::Kind::kLine, palette.intra_residual, colors.unknown}, "INTRA residual"},
      {{Swatch::Kind::kPoint, palette.node, colors.unknown}, "node"},
      {{Swatch::Kind::kLine, palette.axis_x, colors.unknown}, "x of a submap"},
      {{Swatch::Kind::kLine, palette.axis_y, colors.unknown}, "y of a submap"},
      {{Swatch::Kind::kRobot, palette.robot, colors.unknown}, "robot"}};
  annotation.facts = FactsOf(graph);
  return annotation;
}

void DrawConstraints(const Graph& graph, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(0, LayerKind::kIntra,
             [&] { return IntraConstraintsLayer(graph.intra, 0.5, sheet->Px(widths::kHairline)); });
  sheet->Add(0, LayerKind::kInter, [&] {
    return InterConstraintsLayer(graph.inter, WithOpacity(palette.inter, 0.7),
                                 sheet->Px(widths::kThin));
  });
  sheet->Add(0, LayerKind::kResiduals, [&] {
    return ResidualsLayer(graph.intra, palette.intra_residual, sheet->Px(widths::kLine));
  });
  sheet->Add(0, LayerKind::kResiduals, [&] {
    return ResidualsLayer(graph.inter, palette.inter_residual, sheet->Px(widths::kBold));
  });
}

}  // namespace

Scene BuildGraphView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const Graph graph = GraphAfterStep(recording, StepOf(recording, request));
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = DarkMapColors(palette);
  const std::vector<PlacedGrid> grids = GridsOfState(recording, graph.state);

  Sheet sheet(request, oversampling, Describe(recording, graph, colors, palette));
  sheet.Open(0, ExtentOf(grids), colors.unknown);
  DrawMap(grids, colors, &sheet);
  DrawConstraints(graph, &sheet);
  DrawPoses(graph.state,
            {WithOpacity(palette.node, 0.6), palette.node, palette.dark_label,
             WithOpacity(palette.dark_unknown, 0.6)},
            &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
