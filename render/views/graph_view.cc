// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/graph/outliers.h"
#include "core/slam/derive.h"
#include "render/layers/constraints.h"
#include "render/number_text.h"
#include "render/views/grids.h"
#include "render/views/highlight.h"
#include "render/views/pose_layers.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/uncertainty.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

/// The pose graph after a step.
struct Graph {
  MapState state;
  std::vector<PlacedConstraint> intra;
  std::vector<PlacedConstraint> inter;     ///< in force
  std::vector<PlacedConstraint> outliers;  ///< loops that the optimization leaves out
  std::vector<PlacedConstraint> refused;   ///< loops that were found, but not believed
};

std::vector<Constraint> RefusedLoops(const Recording& recording, const MapState& state) {
  std::vector<Constraint> refused;
  for (int i = 0; i < state.num_candidates; ++i) {
    const LoopCandidate& candidate = recording.candidates()[i];
    if (!IsRefused(candidate.verdict)) continue;
    refused.push_back({candidate.submap, candidate.node, candidate.submap_from_node, 0.0, 0.0,
                       Constraint::Tag::kInterSubmap});
  }
  return refused;
}

Graph GraphAfterStep(const Recording& recording, int step) {
  Graph graph{StateAfterStep(recording, step), {}, {}, {}, {}};
  const std::vector<Constraint> constraints = ConstraintsOf(recording, graph.state);
  graph.intra = PlaceConstraints(constraints, Constraint::Tag::kIntraSubmap, graph.state);
  const OutlierOptions& options = recording.options().pose_graph.optimization_problem.outliers;
  for (const PlacedConstraint& loop :
       PlaceConstraints(constraints, Constraint::Tag::kInterSubmap, graph.state)) {
    const bool is_outlier = IsOutlier(loop.constraint, graph.state.global_from_submap,
                                      graph.state.global_from_node, options);
    (is_outlier ? graph.outliers : graph.inter).push_back(loop);
  }
  graph.refused = PlaceConstraints(RefusedLoops(recording, graph.state),
                                   Constraint::Tag::kInterSubmap, graph.state);
  return graph;
}

double MeanResidual(const std::vector<PlacedConstraint>& constraints) {
  double sum = 0.0;
  for (const PlacedConstraint& constraint : constraints) sum += constraint.residual();
  return sum / static_cast<double>(constraints.size());
}

/// The loop in force that the map contradicts most; null if there is none.
const PlacedConstraint* Worst(const Graph& graph) {
  if (graph.inter.empty()) return nullptr;
  return &*std::max_element(
      graph.inter.begin(), graph.inter.end(),
      [](const auto& a, const auto& b) { return a.residual() < b.residual(); });
}

std::vector<Fact> FactsOf(const Graph& graph) {
  std::vector<Fact> facts{{"nodes", fmt::format("{}", graph.state.num_nodes)},
                          {"submaps", fmt::format("{}", graph.state.num_submaps)},
                          {"INTRA", fmt::format("{}", graph.intra.size())},
                          {"INTER", fmt::format("{}", graph.inter.size())},
                          {"loops refused", fmt::format("{}", graph.refused.size())},
                          {"optimizations", fmt::format("{}", graph.state.num_optimizations)}};
  if (!graph.outliers.empty()) {
    facts.push_back({"outliers", fmt::format("{}", graph.outliers.size())});
  }
  if (const PlacedConstraint* const worst = Worst(graph)) {
    facts.push_back({"mean residual", LengthText(MeanResidual(graph.inter))});
    facts.push_back({"worst residual", LengthText(worst->residual())});
    facts.push_back({"of node", ToString(worst->constraint.node)});
    facts.push_back({"in submap", ToString(worst->constraint.submap)});
  }
  return facts;
}

LayerKeys KeysOf(const Graph& graph, const MapColors& colors, const Palette& palette,
                 const Highlight& highlight) {
  const auto line = [&](LayerKind kind, const Color& color, const char* label) {
    return std::pair(kind, LegendEntry{{Swatch::Kind::kLine, color, colors.unknown}, label});
  };
  LayerKeys keys{
      {line(LayerKind::kInter, palette.inter, "INTER constraint"),
       line(LayerKind::kResiduals, palette.inter_residual, "INTER residual"),
       line(LayerKind::kIntra, HueOf(1), "INTRA constraint, by submap"),
       line(LayerKind::kResiduals, palette.intra_residual, "INTRA residual"),
       line(LayerKind::kRefused, palette.refused, "refused loop"),
       line(LayerKind::kCovariances, palette.covariance, "covariance of a submap"),
       {LayerKind::kNodes, {{Swatch::Kind::kPoint, palette.node, colors.unknown}, "node"}},
       {LayerKind::kFrames, {{Swatch::Kind::kFrame, {}, colors.unknown}, "frame of a submap"}},
       {LayerKind::kRobot, {{Swatch::Kind::kRobot, palette.robot, colors.unknown}, "robot"}}},
      {}};
  if (!graph.outliers.empty()) {
    keys.legend.insert(keys.legend.begin() + 1,
                       line(LayerKind::kInter, palette.outlier, "INTER, left out as outlier"));
  }
  if (!highlight.empty()) {
    keys.legend.emplace_back(LayerKind::kSelection, HighlightEntry(colors, palette));
  }
  return keys;
}

Annotation Describe(const Recording& recording, const Graph& graph) {
  Annotation annotation;
  annotation.title = "Pose graph";
  annotation.subtitle = Subtitle(recording, graph.state.step, {});
  annotation.facts = FactsOf(graph);
  return annotation;
}

/// Ellipses so large that they are seen: weights of constraints are no standard deviations.
void DrawCovariances(const Recording& recording, const MapState& state, Sheet* sheet) {
  constexpr int kMaxCount = 12;  // a covariance takes as long as an optimization
  sheet->Add(0, LayerKind::kCovariances, [&] {
    const auto points = UncertaintyOfSubmaps(recording, state, kMaxCount);
    const double factor = EllipseFactor(points, sheet->Meters(0, 2.0 * widths::kAxis));
    sheet->Say(0, fmt::format("ellipses: {:g} standard deviations", factor));
    return EllipsesLayer(points, factor, sheet->palette().covariance, sheet->Px(widths::kLine));
  });
}

/// The constraints of what is selected, clearer than the others.
void DrawLinks(const Graph& graph, const Highlight& highlight, Sheet* sheet) {
  if (highlight.empty() || !sheet->Shows(LayerKind::kSelection)) return;
  sheet->Add(0, LayerKind::kIntra, [&] {
    return IntraConstraintsLayer(LinksOf(highlight, graph.intra), 1.0, sheet->Px(widths::kLine));
  });
  sheet->Add(0, LayerKind::kRefused, [&] {
    return InterConstraintsLayer(LinksOf(highlight, graph.refused), sheet->palette().refused,
                                 sheet->Px(widths::kLine));
  });
  sheet->Add(0, LayerKind::kInter, [&] {
    return InterConstraintsLayer(LinksOf(highlight, graph.inter), sheet->palette().inter,
                                 sheet->Px(widths::kLine));
  });
}

/// The worst loop wider than the others, with its residual written at its node, while nothing else
/// is selected.
Written DrawWorst(const Graph& graph, const PoseColors& colors, Sheet* sheet) {
  const PlacedConstraint* const worst = Worst(graph);
  if (worst == nullptr || !sheet->Shows(LayerKind::kInter)) return {};
  const Palette& palette = sheet->palette();
  for (const auto& [color, width] : Edged(palette.inter, widths::kBold, palette)) {
    sheet->Add(0, LayerKind::kInter, [&, color = color, width = width] {
      return InterConstraintsLayer({*worst}, color, sheet->Px(width));
    });
  }
  const TextStyle style = TextStyleOf(sheet->size(), colors.label);
  Written written;
  WriteBeside(worst->expected_node, "worst loop: " + LengthText(worst->residual()), style, *sheet,
              &written.labels);
  sheet->Add(0, LayerKind::kInter,
             [&] { return LabelsLayer(written.labels, style, colors.label_plate); });
  return written;
}

/// Adds what `draw` makes of `constraints`, and if they are many of some of them for the moving
/// camera.
template <typename Draw>
void AddLines(LayerKind kind, const std::vector<PlacedConstraint>& constraints, const Draw& draw,
              Sheet* sheet) {
  constexpr int kMany = 3000;
  constexpr int kMaxMoving = 1000;
  if (constraints.size() <= kMany) {
    sheet->Add(0, kind, [&] { return draw(constraints); });
    return;
  }
  sheet->Add(
      0, kind, [&] { return draw(constraints); }, Sheet::When::kAtRest);
  sheet->Add(
      0, kind, [&] { return draw(Thinned(constraints, kMaxMoving)); }, Sheet::When::kMoving);
}

/// Those whose residual is seen. Of thousands of INTRA constraints that is true of a few, and a
/// wide line costs as much however short it is.
std::vector<PlacedConstraint> WithVisibleResidual(const std::vector<PlacedConstraint>& constraints,
                                                  double meters_per_pixel) {
  constexpr double kMinPixels = 0.5;
  std::vector<PlacedConstraint> visible;
  for (const PlacedConstraint& constraint : constraints) {
    if (constraint.residual() >= kMinPixels * meters_per_pixel) visible.push_back(constraint);
  }
  return visible;
}

/// `dimming` in [0, 1] multiplies the opacity of the lines between submaps and nodes.
void DrawConstraints(const Graph& graph, double dimming, Sheet* sheet) {
  using Lines = std::vector<PlacedConstraint>;
  const Palette& palette = sheet->palette();
  const auto intra = [&](const Lines& lines) {
    return IntraConstraintsLayer(lines, dimming * OpacityOfMany(lines.size() / 4),
                                 sheet->Px(widths::kHairline));
  };
  const auto refused = [&](const Lines& lines) {
    return InterConstraintsLayer(lines, WithOpacity(palette.refused, dimming),
                                 sheet->Px(widths::kHairline));
  };
  const auto inter = [&](const Lines& lines) {
    const Color color = WithOpacity(palette.inter, dimming * OpacityOfMany(lines.size()));
    return InterConstraintsLayer(lines, color, sheet->Px(widths::kThin));
  };
  const auto intra_residuals = [&](const Lines& lines) {
    return ResidualsLayer(lines, palette.intra_residual, sheet->Px(widths::kLine));
  };
  const auto inter_residuals = [&](const Lines& lines) {
    return ResidualsLayer(lines, palette.inter_residual, sheet->Px(widths::kBold));
  };
  AddLines(LayerKind::kIntra, graph.intra, intra, sheet);
  AddLines(LayerKind::kRefused, graph.refused, refused, sheet);
  AddLines(LayerKind::kInter, graph.inter, inter, sheet);
  for (const auto& [color, width] : Edged(palette.outlier, widths::kLine, palette)) {
    const auto outliers = [&, color = color, width = width](const Lines& lines) {
      return InterConstraintsLayer(lines, WithOpacity(color, dimming), sheet->Px(width));
    };
    AddLines(LayerKind::kInter, graph.outliers, outliers, sheet);
  }
  const double pixel = sheet->camera(0).meters_per_pixel;
  AddLines(LayerKind::kResiduals, WithVisibleResidual(graph.intra, pixel), intra_residuals, sheet);
  AddLines(LayerKind::kResiduals, WithVisibleResidual(graph.inter, pixel), inter_residuals, sheet);
}

}  // namespace

Scene BuildGraphView(DerivedCache* cache, const ViewRequest& request, int oversampling) {
  const Recording& recording = cache->recording();
  const Graph graph = GraphAfterStep(recording, StepOf(recording, request));
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = DarkMapColors(palette);
  const std::vector<PlacedGrid> grids = PlacedGridsOf(cache, graph.state);

  const Highlight highlight = HighlightOf(recording, request, graph.state, grids);

  Sheet sheet(request, oversampling, Describe(recording, graph),
              KeysOf(graph, colors, palette, highlight));
  sheet.Open(0, ExtentOf(grids), colors.unknown);
  DrawMap(grids, colors, &cache->map_composer(), &sheet);
  const bool is_selected = !highlight.empty() && sheet.Shows(LayerKind::kSelection);
  DrawConstraints(graph, is_selected ? 0.5 : 1.0, &sheet);
  DrawLinks(graph, highlight, &sheet);
  DrawCovariances(recording, graph.state, &sheet);
  const PoseColors pose_colors{WithOpacity(palette.node, 0.6), palette.node, palette.dark_label,
                               WithOpacity(palette.dark_unknown, 0.6)};
  const Written written = is_selected ? DrawHighlight(highlight, pose_colors, &sheet)
                                      : DrawWorst(graph, pose_colors, &sheet);
  DrawPoses(graph.state, pose_colors, written, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
