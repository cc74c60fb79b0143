// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "render/layers/scan.h"
#include "render/layers/trajectory.h"
#include "render/number_text.h"
#include "render/views/grids.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

/// A submap as it was after a step.
struct SubmapAt {
  SubmapId id;
  int step = 0;
  int num_nodes = 0;
  PlacedGrid grid;
  std::vector<Pose2> submap_from_node;
};

SubmapAt SubmapAfterStep(const Recording& recording, SubmapId id, int step) {
  SubmapAt submap{id, step, NumNodesOfSubmapAfterStep(recording, id, step), {}, {}};
  submap.grid = {std::make_shared<ProbabilityGrid>(GridOfSubmap(recording, id, submap.num_nodes)),
                 Pose2()};
  const NodeId first = recording.submap(id).first_node;
  for (int i = 0; i < submap.num_nodes; ++i) {
    submap.submap_from_node.push_back(SubmapFromNode(recording, id, NodeId{first.index + i}));
  }
  return submap;
}

int NumKnownCells(const ProbabilityGrid& grid) {
  const auto& cells = grid.cells();
  return static_cast<int>(cells.size() - std::count(cells.begin(), cells.end(), kUnknown));
}

LayerKeys KeysOf(const MapColors& colors, const Palette& palette) {
  return {{{LayerKind::kGrid, UnknownEntry(colors)},
           {LayerKind::kScan,
            {{Swatch::Kind::kPoint, palette.scan, colors.free}, "returns of its scans"}},
           {LayerKind::kTrajectory,
            {{Swatch::Kind::kLine, palette.trajectory, colors.free}, "way of the robot"}},
           {LayerKind::kNodes, {{Swatch::Kind::kPoint, palette.trajectory, colors.free}, "node"}},
           {LayerKind::kFrames, {{Swatch::Kind::kFrame, {}, colors.free}, "its frame"}}},
          {{LayerKind::kGrid, OccupancyBar(colors)}}};
}

Annotation Describe(const Recording& recording, const SubmapAt& submap) {
  const Submap& record = recording.submap(submap.id);
  const ProbabilityGrid& grid = *submap.grid.grid;
  const CellBox& box = grid.box();
  const double r = grid.resolution();
  const bool finished = record.finished_step >= 0 && record.finished_step <= submap.step;
  Annotation annotation;
  annotation.title = "Submap " + ToString(submap.id);
  annotation.subtitle = Subtitle(recording, submap.step, {});
  annotation.facts = {
      {"nodes", fmt::format("{} to {}", record.first_node.index,
                            record.first_node.index + submap.num_nodes - 1)},
      {"scans in it", fmt::format("{}", submap.num_nodes)},
      {"finished", finished ? fmt::format("step {}", record.finished_step) : "not yet"},
      {"cell", LengthText(r)},
      {"size", fmt::format("{:.1f} m × {:.1f} m", box.width * r, box.height * r)},
      {"seen", fmt::format("{:.0f} m²", NumKnownCells(grid) * r * r)}};
  return annotation;
}

/// The returns of all scans of the submap, in its frame.
PointCloud ReturnsIn(const Recording& recording, const SubmapAt& submap) {
  PointCloud all;
  for (int i = 0; i < submap.num_nodes; ++i) {
    const NodeId node{recording.submap(submap.id).first_node.index + i};
    const RangeData data = RangeDataOfStep(recording, recording.node(node).step);
    for (const Eigen::Vector2d& point : data.returns) {
      all.push_back(submap.submap_from_node[i] * point);
    }
  }
  return all;
}

}  // namespace

Scene BuildSubmapView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const SubmapAt submap =
      SubmapAfterStep(recording, SubmapOf(recording, request), StepOf(recording, request));
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);

  Sheet sheet(request, oversampling, Describe(recording, submap), KeysOf(colors, palette));
  sheet.Open(0, ExtentOf(submap.grid), colors.unknown);
  sheet.Add(0, LayerKind::kGrid, [&] {
    return CellImageLayer(GridImage(*submap.grid.grid, colors), Pose2(),
                          submap.grid.grid->resolution());
  });
  sheet.Add(0, LayerKind::kScan, [&] {
    return ScanLayer(ReturnsIn(recording, submap), Pose2(), WithOpacity(palette.scan, 0.25),
                     sheet.Px(0.5 * widths::kScanPoint));
  });
  sheet.Add(0, LayerKind::kTrajectory, [&] {
    return TrajectoryLayer(submap.submap_from_node, palette.trajectory, sheet.Px(widths::kThin));
  });
  sheet.Add(0, LayerKind::kNodes, [&] {
    return NodesLayer(submap.submap_from_node,
                      std::vector<Color>(submap.num_nodes, palette.trajectory),
                      sheet.Px(widths::kNode));
  });
  sheet.Add(0, LayerKind::kFrames, [&] {
    return FramesLayer({Pose2()}, sheet.Meters(0, 2.0 * widths::kAxis), sheet.Px(widths::kBold),
                       palette);
  });
  return sheet.Finish();
}

}  // namespace loopscope
