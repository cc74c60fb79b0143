// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "render/layers/constraints.h"
#include "render/layers/map_image.h"
#include "render/views/pose_layers.h"

namespace loopscope {

/// What is selected, in the map frame; without what does not exist yet.
struct Highlight {
  bool empty() const { return !node && !submap && marked.empty(); }

  std::optional<NodeId> node;
  std::optional<SubmapId> submap;
  Eigen::Vector2d node_place = Eigen::Vector2d::Zero();  ///< [m]
  Pose2 global_from_submap;
  std::vector<Eigen::Vector2d> known_area;  ///< corners [m] of the box around its known cells
  std::optional<PlacedConstraint> link;     ///< constraint or loop candidate between the two
  std::string link_text;                    ///< what it is, with score and residual
  std::vector<PlacedConstraint> marked;     ///< further loops
};

/// What of the node, the submap and the marked loops of `request` there is in `state`; `grids` are
/// its submaps. Throws std::invalid_argument if the recording has no such node or submap.
Highlight HighlightOf(const Recording& recording, const ViewRequest& request, const MapState& state,
                      const std::vector<PlacedGrid>& grids);

/// How a legend explains it.
LegendEntry HighlightEntry(const MapColors& colors, const Palette& palette);

/// Those constraints that lead to the node or the submap.
std::vector<PlacedConstraint> LinksOf(const Highlight& highlight,
                                      const std::vector<PlacedConstraint>& constraints);

/// Writes `text` beside `place`, in one of four ways: the first that leaves all of `labels` free.
void WriteBeside(const Eigen::Vector2d& place, const std::string& text, const TextStyle& style,
                 const Sheet& sheet, std::vector<Label>* labels);

/// Colours and widths of lines that are seen on all others: dark ones, and in them those asked for.
std::array<std::pair<Color, double>, 2> Edged(const Color& color, double width,
                                              const Palette& palette);

/// Draws the node as a ring, the submap as the box around its known cells and a bold frame, and the
/// link between them with its residual, in panel 0; over them their ids and what the link is, in
/// the colours of labels. Returns what was written.
Written DrawHighlight(const Highlight& highlight, const PoseColors& colors, Sheet* sheet);

}  // namespace loopscope
