// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/pose_layers.h"

#include "render/layers/robot.h"
#include "render/layers/trajectory.h"

namespace loopscope {
namespace {

void DrawLabels(const MapState& state, const PoseColors& colors, const Written& written,
                Sheet* sheet) {
  const TextStyle style = TextStyleOf(sheet->size(), colors.label);
  const Eigen::Vector2d beside =
      Eigen::Vector2d(0.3, 0.3) * sheet->Meters(0, widths::kAxis);  // clear of the axes
  std::vector<Label> labels = written.labels;
  for (SubmapId id{0}; id.index < state.num_submaps; ++id.index) {
    if (id == written.submap) continue;
    labels.push_back({state.global_from_submap[id.index].translation + beside, ToString(id)});
  }
  sheet->Add(0, LayerKind::kLabels, [&] {
    std::vector<Label> kept = WithoutOverlaps(labels, sheet->camera(0), sheet->frame(0), style);
    kept.erase(kept.begin(), kept.begin() + static_cast<std::ptrdiff_t>(written.labels.size()));
    return LabelsLayer(kept, style, colors.label_plate);
  });
}

}  // namespace

void DrawMap(const std::vector<PlacedGrid>& grids, const MapColors& colors, MapComposer* composer,
             Sheet* sheet) {
  if (grids.empty()) return;
  const double resolution = grids.front().grid->resolution();
  sheet->Add(0, LayerKind::kGrid, [&] {
    return MapLayer(grids, RasterFor(sheet->camera(0), sheet->frame(0), resolution), colors,
                    composer);
  });
}

void DrawPoses(const MapState& state, const PoseColors& colors, const Written& written,
               Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(0, LayerKind::kTrajectory, [&] {
    return TrajectoryLayer(state.global_from_node, colors.trajectory, sheet->Px(widths::kThin));
  });
  sheet->Add(0, LayerKind::kNodes, [&] {
    return NodesLayer(state.global_from_node, std::vector<Color>(state.num_nodes, colors.node),
                      sheet->Px(widths::kNode));
  });
  sheet->Add(0, LayerKind::kFrames, [&] {
    return FramesLayer(state.global_from_submap, sheet->Meters(0, widths::kAxis),
                       sheet->Px(widths::kBold), palette);
  });
  sheet->Add(0, LayerKind::kRobot, [&] {
    return RobotLayer(state.global_from_base, sheet->Meters(0, 1.5 * widths::kMark),
                      sheet->Meters(0, widths::kThin), palette.robot);
  });
  DrawLabels(state, colors, written, sheet);
}

}  // namespace loopscope
