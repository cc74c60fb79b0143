// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "render/views/grids.h"
#include "render/views/highlight.h"
#include "render/views/pose_layers.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

double LengthOf(const std::vector<Pose2>& poses) {
  double length = 0.0;
  for (std::size_t i = 1; i < poses.size(); ++i) {
    length += (poses[i].translation - poses[i - 1].translation).norm();
  }
  return length;
}

int NumLoops(const Recording& recording, const MapState& state) {
  int count = 0;
  for (int i = 0; i < state.num_candidates; ++i) {
    count += recording.candidates()[i].verdict == Verdict::kAccepted;
  }
  return count;
}

LayerKeys KeysOf(const MapColors& colors, const Palette& palette, const Highlight& highlight) {
  LayerKeys keys{
      {{LayerKind::kGrid, UnknownEntry(colors)},
       {LayerKind::kTrajectory,
        {{Swatch::Kind::kLine, palette.trajectory, colors.free}, "way of the robot"}},
       {LayerKind::kNodes, {{Swatch::Kind::kPoint, palette.trajectory, colors.free}, "node"}},
       {LayerKind::kFrames, {{Swatch::Kind::kFrame, {}, colors.free}, "frame of a submap"}},
       {LayerKind::kRobot, {{Swatch::Kind::kRobot, palette.robot, colors.free}, "robot"}}},
      {{LayerKind::kGrid, OccupancyBar(colors)}}};
  if (!highlight.empty()) {
    keys.legend.emplace_back(LayerKind::kSelection, HighlightEntry(colors, palette));
  }
  return keys;
}

Annotation Describe(const Recording& recording, const MapState& state, const Extent& extent) {
  Annotation annotation;
  annotation.title = "Map";
  annotation.subtitle = Subtitle(recording, state.step, {});
  annotation.facts = {{"nodes", fmt::format("{}", state.num_nodes)},
                      {"submaps", fmt::format("{}", state.num_submaps)},
                      {"loops closed", fmt::format("{}", NumLoops(recording, state))},
                      {"way", fmt::format("{:.0f} m", LengthOf(state.global_from_node))}};
  if (!extent.isEmpty()) {
    annotation.facts.push_back(
        {"size", fmt::format("{:.0f} m × {:.0f} m", extent.sizes().x(), extent.sizes().y())});
  }
  return annotation;
}

}  // namespace

Scene BuildMapView(DerivedCache* cache, const ViewRequest& request, int oversampling) {
  const Recording& recording = cache->recording();
  const MapState state = StateAfterStep(recording, StepOf(recording, request));
  const std::vector<PlacedGrid> grids = PlacedGridsOf(cache, state);
  const Extent extent = ExtentOf(grids);
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);

  const Highlight highlight = HighlightOf(recording, request, state, grids);

  Sheet sheet(request, oversampling, Describe(recording, state, extent),
              KeysOf(colors, palette, highlight));
  sheet.Open(0, extent, colors.unknown);
  DrawMap(grids, colors, &cache->map_composer(), &sheet);
  const PoseColors pose_colors{palette.trajectory, palette.trajectory, palette.ink,
                               WithOpacity(palette.paper, 0.7)};
  DrawPoses(state, pose_colors, DrawHighlight(highlight, pose_colors, &sheet), &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
