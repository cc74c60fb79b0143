// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/highlight.h"

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"
#include "render/layers/shapes.h"
#include "render/layers/trajectory.h"
#include "render/number_text.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

using Tag = Constraint::Tag;

/// Corners of the box around the known cells, to the edges of the cells.
std::vector<Eigen::Vector2d> KnownArea(const PlacedGrid& placed) {
  const CellBox& box = placed.grid->box();
  if (box.empty()) return {};
  const double r = placed.grid->resolution();
  const Eigen::Vector2d min = CenterOf(box.min, r) - Eigen::Vector2d(0.5 * r, 0.5 * r);
  return RectangleCorners(placed.map_from_grid, min,
                          min + r * Eigen::Vector2d(box.width, box.height));
}

/// The pair if it was searched until `state`.
const LoopCandidate* SearchedPair(const Recording& recording, const MapState& state,
                                  const LoopPair& pair) {
  const auto index = recording.FindCandidate(pair.submap, pair.node, state.num_candidates);
  if (!index || recording.candidates()[*index].verdict == Verdict::kNotSampled) return nullptr;
  return &recording.candidates()[*index];
}

PlacedConstraint LinkOf(const LoopCandidate& found, const MapState& state) {
  return PlaceConstraints(
             {{found.submap, found.node, found.submap_from_node, 0.0, 0.0, Tag::kInterSubmap}},
             Tag::kInterSubmap, state)
      .front();
}

/// Sets the link if there is one.
void FindLink(const Recording& recording, const MapState& state, Highlight* highlight) {
  const SubmapId submap = *highlight->submap;
  const NodeId node = *highlight->node;
  if (recording.node(node).LiesIn(submap)) {
    const Pose2 submap_from_node = SubmapFromNode(recording, submap, node);
    highlight->link =
        PlaceConstraints({{submap, node, submap_from_node, 0.0, 0.0, Tag::kIntraSubmap}},
                         Tag::kIntraSubmap, state)
            .front();
    highlight->link_text = "INTRA, residual " + LengthText(highlight->link->residual());
    return;
  }
  const LoopCandidate* const found = SearchedPair(recording, state, {node, submap});
  if (found == nullptr) return;
  highlight->link = LinkOf(*found, state);
  const bool accepted = found->verdict == Verdict::kAccepted;
  highlight->link_text = fmt::format("{}, score {:.3f}, residual {}",
                                     accepted ? "INTER" : "no loop: " + ToString(found->verdict),
                                     found->score, LengthText(highlight->link->residual()));
}

void AddLines(const Highlight& highlight, double ring_radius, const Color& color, Shapes* shapes) {
  shapes->AddOutline(highlight.known_area, color);
  if (highlight.link) shapes->AddLine(highlight.link->submap, highlight.link->expected_node, color);
  if (highlight.node) shapes->AddCircle(highlight.node_place, ring_radius, color);
  for (const PlacedConstraint& loop : highlight.marked) {
    shapes->AddLine(loop.submap, loop.expected_node, color);
    shapes->AddCircle(loop.node, ring_radius, color);
  }
}

/// The lines of the highlight in `color`, `width` of the palette.
void DrawLines(const Highlight& highlight, const Color& color, double width, Sheet* sheet) {
  sheet->Add(0, LayerKind::kSelection, [&] {
    Shapes shapes;
    AddLines(highlight, sheet->Meters(0, 0.8 * widths::kMark), color, &shapes);
    return MakeActor(shapes.Build(), {sheet->Px(width), 1.0, false});
  });
}

void DrawResidual(const PlacedConstraint& link, const Color& color, double width, Sheet* sheet) {
  sheet->Add(0, LayerKind::kSelection,
             [&] { return ResidualsLayer({link}, color, sheet->Px(width)); });
}

/// The ids of what is selected, and its link, where they can be read.
std::vector<Label> LabelsOf(const Highlight& highlight, const TextStyle& style,
                            const Sheet& sheet) {
  std::vector<Label> labels;
  const auto write = [&](const Eigen::Vector2d& place, const std::string& text) {
    WriteBeside(place, text, style, sheet, &labels);
  };
  if (highlight.link) {
    write(0.5 * (highlight.link->submap + highlight.link->expected_node), highlight.link_text);
  }
  if (highlight.node) write(highlight.node_place, "node " + ToString(*highlight.node));
  if (highlight.submap) {
    write(highlight.global_from_submap.translation, "submap " + ToString(*highlight.submap));
  }
  return labels;
}

}  // namespace

Highlight HighlightOf(const Recording& recording, const ViewRequest& request, const MapState& state,
                      const std::vector<PlacedGrid>& grids) {
  Highlight highlight;
  if (request.node) RequireNode(recording, *request.node);
  if (request.submap) RequireSubmap(recording, *request.submap);
  if (request.node && request.node->index < state.num_nodes) {
    highlight.node = request.node;
    highlight.node_place = state.global_from_node[request.node->index].translation;
  }
  if (request.submap && request.submap->index < state.num_submaps) {
    highlight.submap = request.submap;
    highlight.global_from_submap = state.global_from_submap[request.submap->index];
    highlight.known_area = KnownArea(grids[request.submap->index]);
  }
  if (highlight.node && highlight.submap) FindLink(recording, state, &highlight);
  for (const LoopPair& pair : request.marked) {
    RequireNode(recording, pair.node);
    RequireSubmap(recording, pair.submap);
    const LoopCandidate* const found = SearchedPair(recording, state, pair);
    if (found != nullptr) highlight.marked.push_back(LinkOf(*found, state));
  }
  return highlight;
}

void WriteBeside(const Eigen::Vector2d& place, const std::string& text, const TextStyle& style,
                 const Sheet& sheet, std::vector<Label>* labels) {
  if (!sheet.Visible(0).contains(place)) return;
  const FlatCamera& camera = sheet.camera(0);
  const double gap = sheet.Meters(0, widths::kMark);
  const double left = -gap - camera.meters_per_pixel * TextWidth(text, style);
  const double below = -gap - 1.3 * camera.meters_per_pixel * style.size;
  for (const auto& [x, y] :
       {std::pair(gap, gap), std::pair(left, gap), std::pair(gap, below), std::pair(left, below)}) {
    const Label label{place + Eigen::Vector2d(x, y), text};
    labels->push_back(MovedInside(label, camera, sheet.frame(0), style));
    if (WithoutOverlaps(*labels, camera, sheet.frame(0), style).size() == labels->size()) return;
    labels->pop_back();
  }
}

LegendEntry HighlightEntry(const MapColors& colors, const Palette& palette) {
  return {{Swatch::Kind::kOutline, palette.selection, colors.unknown}, "selected"};
}

std::vector<PlacedConstraint> LinksOf(const Highlight& highlight,
                                      const std::vector<PlacedConstraint>& constraints) {
  std::vector<PlacedConstraint> links;
  for (const PlacedConstraint& placed : constraints) {
    if (highlight.node == placed.constraint.node || highlight.submap == placed.constraint.submap) {
      links.push_back(placed);
    }
  }
  return links;
}

std::array<std::pair<Color, double>, 2> Edged(const Color& color, double width,
                                              const Palette& palette) {
  return {std::pair(palette.selection_edge, width + 2.0 * widths::kThin), std::pair(color, width)};
}

Written DrawHighlight(const Highlight& highlight, const PoseColors& colors, Sheet* sheet) {
  if (highlight.empty() || !sheet->Shows(LayerKind::kSelection)) return {};
  constexpr double kWidth = 1.1 * widths::kBold;
  const Palette& palette = sheet->palette();
  for (const auto& [color, width] : Edged(palette.selection, kWidth, palette)) {
    DrawLines(highlight, color, width, sheet);
  }
  if (highlight.link) {
    const bool intra = highlight.link->constraint.tag == Tag::kIntraSubmap;
    for (const auto& [color, width] :
         Edged(intra ? palette.intra_residual : palette.inter_residual, kWidth, palette)) {
      DrawResidual(*highlight.link, color, width, sheet);
    }
  }
  if (highlight.submap) {
    sheet->Add(0, LayerKind::kSelection, [&] {
      return FramesLayer({highlight.global_from_submap}, sheet->Meters(0, 1.5 * widths::kAxis),
                         sheet->Px(1.6 * widths::kBold), palette);
    });
  }
  const TextStyle style = TextStyleOf(sheet->size(), colors.label);
  const std::vector<Label> labels = LabelsOf(highlight, style, *sheet);
  sheet->Add(0, LayerKind::kSelection,
             [&] { return LabelsLayer(labels, style, WithOpacity(colors.label_plate, 0.85)); });
  return {labels, highlight.submap};
}

}  // namespace loopscope
