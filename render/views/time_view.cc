// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <fmt/format.h>

#include "core/graph/outliers.h"
#include "core/slam/derive.h"
#include "render/layers/labels.h"
#include "render/layers/robot.h"
#include "render/layers/time_layers.h"
#include "render/views/grids.h"
#include "render/views/highlight.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

using Vector = Eigen::Vector2d;

/// The pose graph after a step, each node at the height of its time.
struct RisingGraph {
  MapState state;
  std::vector<PlacedConstraint> intra;
  std::vector<PlacedConstraint> inter;  ///< in force
  TimeScale scale;
  double time = 0.0;  ///< of the step, since the first scan [s]
  std::vector<double> node_heights;
  std::vector<double> submap_heights;

  double height() const { return scale.meters_per_second * time; }
};

RisingGraph GraphAfterStep(const Recording& recording, int step) {
  constexpr double kHeight = 0.5;  // of the run, for the size of its map
  RisingGraph graph;
  graph.state = StateAfterStep(recording, step);
  const std::vector<Constraint> constraints = WithoutOutliers(
      ConstraintsOf(recording, graph.state), graph.state.global_from_submap,
      graph.state.global_from_node, recording.options().pose_graph.optimization_problem.outliers);
  graph.intra = PlaceConstraints(constraints, Constraint::Tag::kIntraSubmap, graph.state);
  graph.inter = PlaceConstraints(constraints, Constraint::Tag::kInterSubmap, graph.state);
  graph.scale = TimeScaleOf(recording, kHeight);
  graph.time = recording.log().scans[step].time - graph.scale.first_time;
  graph.node_heights = HeightsOfNodes(recording, graph.scale, graph.state.num_nodes);
  graph.submap_heights = HeightsOfSubmaps(recording, graph.scale, graph.state.num_submaps);
  return graph;
}

/// The map beneath and the axis at its corner that is farthest to the left in the picture.
struct Floor {
  std::vector<PlacedGrid> grids;
  Extent extent;
  Vector axis = Vector::Zero();
};

Floor FloorOf(std::vector<PlacedGrid> grids, const Eigen::Matrix3d& view_from_map) {
  Floor floor{std::move(grids), {}, {}};
  floor.extent = ExtentOf(floor.grids);
  if (floor.extent.isEmpty()) floor.extent.extend(Vector(0.0, 0.0));
  const auto corners = RectangleCorners(Pose2(), floor.extent.min(), floor.extent.max());
  floor.axis = *std::min_element(corners.begin(), corners.end(), [&](const auto& a, const auto& b) {
    return view_from_map.row(0).head<2>() * a < view_from_map.row(0).head<2>() * b;
  });
  return floor;
}

/// All of it in the coordinates of the camera, with room for the numbers beside the axis, which is
/// a `share` of the width.
Extent ExtentInView(const Floor& floor, double height, const Eigen::Matrix3d& view_from_map,
                    double share) {
  Extent extent;
  for (const Vector& corner : RectangleCorners(Pose2(), floor.extent.min(), floor.extent.max())) {
    for (const double z : {0.0, height}) {
      extent.extend((view_from_map * Eigen::Vector3d(corner.x(), corner.y(), z)).head<2>());
    }
  }
  const Vector room(extent.sizes().x() * share / (1.0 - share), 0.0);
  extent.extend(Vector(extent.min() - room));
  return extent;
}

LayerKeys KeysOf(const MapColors& colors, const Palette& palette, const Highlight& highlight) {
  LayerKeys keys{
      {{LayerKind::kInter,
        {{Swatch::Kind::kLine, palette.inter, colors.unknown}, "INTER constraint"}},
       {LayerKind::kIntra,
        {{Swatch::Kind::kLine, HueOf(1), colors.unknown}, "INTRA constraint, by submap"}},
       {LayerKind::kNodes, {{Swatch::Kind::kPoint, palette.node, colors.unknown}, "node"}},
       {LayerKind::kFrames, {{Swatch::Kind::kFrame, {}, colors.unknown}, "frame of a submap"}},
       {LayerKind::kRobot, {{Swatch::Kind::kRobot, palette.robot, colors.unknown}, "robot"}}},
      {}};
  if (!highlight.empty()) {
    keys.legend.emplace_back(
        LayerKind::kSelection,
        LegendEntry{{Swatch::Kind::kPoint, palette.selection, colors.unknown}, "selected"});
  }
  return keys;
}

Annotation Describe(const Recording& recording, const RisingGraph& graph) {
  Annotation annotation;
  annotation.title = "Pose graph over time";
  annotation.subtitle = Subtitle(recording, graph.state.step, {});
  annotation.facts = {
      {"nodes", fmt::format("{}", graph.state.num_nodes)},
      {"submaps", fmt::format("{}", graph.state.num_submaps)},
      {"INTRA", fmt::format("{}", graph.intra.size())},
      {"INTER", fmt::format("{}", graph.inter.size())},
      {"a metre up is", fmt::format("{:.3g} s", 1.0 / graph.scale.meters_per_second)}};
  return annotation;
}

Raster RasterOver(const Extent& extent, double meters_per_pixel, double resolution) {
  Raster raster;
  raster.pixel_size = std::max(meters_per_pixel, 0.5 * resolution);
  const double half = 0.5 * raster.pixel_size;
  raster.origin = extent.min() + Vector(half, half);
  raster.width = static_cast<int>(std::ceil(extent.sizes().x() / raster.pixel_size));
  raster.height = static_cast<int>(std::ceil(extent.sizes().y() / raster.pixel_size));
  return raster;
}

void DrawFloor(const Floor& floor, const MapColors& colors, MapComposer* composer, Sheet* sheet) {
  if (floor.grids.empty()) return;
  sheet->Add(0, LayerKind::kGrid, [&] {
    const double resolution = floor.grids.front().grid->resolution();
    const double pixel = sheet->camera(0).meters_per_pixel;
    return MapLayer(floor.grids, RasterOver(floor.extent, pixel, resolution), colors, composer);
  });
  sheet->Add(0, LayerKind::kGrid, [&] {
    Shapes edge;
    edge.AddOutline(RectangleCorners(Pose2(), floor.extent.min(), floor.extent.max()),
                    sheet->palette().faint_ink);
    return MakeActor(edge.Build(), {sheet->Px(widths::kThin), 1.0, false});
  });
}

/// What is selected, and what is marked beside it.
struct RisingSelection {
  std::vector<int> nodes;
  std::vector<int> submaps;
  std::vector<PlacedConstraint> links;

  bool empty() const { return nodes.empty() && submaps.empty(); }
};

RisingSelection SelectionOf(const Highlight& highlight) {
  RisingSelection selection;
  if (highlight.node) selection.nodes.push_back(highlight.node->index);
  if (highlight.submap) selection.submaps.push_back(highlight.submap->index);
  if (highlight.link) selection.links.push_back(*highlight.link);
  for (const PlacedConstraint& loop : highlight.marked) {
    selection.nodes.push_back(loop.constraint.node.index);
    selection.links.push_back(loop);
  }
  return selection;
}

template <typename Value>
std::vector<Value> Picked(const std::vector<Value>& values, const std::vector<int>& indices) {
  std::vector<Value> picked;
  for (const int index : indices) picked.push_back(values[index]);
  return picked;
}

void DrawSelection(const RisingGraph& graph, const RisingSelection& selection, Sheet* sheet) {
  if (selection.empty()) return;
  const Palette& palette = sheet->palette();
  sheet->Add(0, LayerKind::kSelection, [&] {
    return RisingConstraintsLayer(selection.links, graph.submap_heights, graph.node_heights,
                                  palette.selection, 1.0, sheet->Px(widths::kBold));
  });
  sheet->Add(0, LayerKind::kSelection, [&] {
    Shapes nodes;  // not hidden by what is in front of them
    for (const int node : selection.nodes) {
      nodes.SetHeight(graph.node_heights[node]);
      nodes.AddPoint(graph.state.global_from_node[node].translation, palette.selection);
    }
    return MakeActor(nodes.Build(), {1.0, sheet->Px(widths::kMark), true});
  });
  sheet->Add(0, LayerKind::kSelection, [&] {
    return RisingFramesLayer(Picked(graph.state.global_from_submap, selection.submaps),
                             Picked(graph.submap_heights, selection.submaps),
                             sheet->Meters(0, 1.5 * widths::kAxis), sheet->Px(1.6 * widths::kBold),
                             palette);
  });
}

void DrawGraph(const RisingGraph& graph, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(0, LayerKind::kIntra, [&] {
    return RisingConstraintsLayer(graph.intra, graph.submap_heights, graph.node_heights,
                                  std::nullopt, OpacityOfMany(graph.intra.size() / 4),
                                  sheet->Px(widths::kHairline));
  });
  sheet->Add(0, LayerKind::kTrajectory, [&] {
    return RisingTrajectoryLayer(graph.state.global_from_node, graph.node_heights, palette.rule,
                                 sheet->Px(widths::kThin));
  });
  sheet->Add(0, LayerKind::kNodes, [&] {
    return RisingNodesLayer(graph.state.global_from_node, graph.node_heights, palette.node,
                            sheet->Px(widths::kNode));
  });
  sheet->Add(0, LayerKind::kInter, [&] {
    return RisingConstraintsLayer(graph.inter, graph.submap_heights, graph.node_heights,
                                  palette.inter, OpacityOfMany(graph.inter.size()),
                                  sheet->Px(widths::kThin));
  });
  sheet->Add(0, LayerKind::kFrames, [&] {
    return RisingFramesLayer(graph.state.global_from_submap, graph.submap_heights,
                             sheet->Meters(0, widths::kAxis), sheet->Px(widths::kLine), palette);
  });
  sheet->Add(0, LayerKind::kRobot, [&] {
    Shapes robot;
    robot.SetHeight(graph.height());
    robot.AddPolygon(
        RobotOutline(graph.state.global_from_base, sheet->Meters(0, 2.0 * widths::kMark)),
        palette.robot);
    return MakeSolidActor(robot.Build());
  });
}

/// The ticks that can be told apart in the picture.
std::vector<double> VisibleTicks(const RisingGraph& graph, const Eigen::Matrix3d& view_from_map,
                                 const Sheet& sheet) {
  const double meters_per_second = graph.scale.meters_per_second * view_from_map(1, 2);
  const double min_distance = 1.5 * sheet.size().font * sheet.camera(0).meters_per_pixel;
  std::vector<double> ticks;
  for (const double seconds : TicksUpTo(graph.time)) {
    const bool is_clear =
        ticks.empty() || meters_per_second * (seconds - ticks.back()) >= min_distance;
    if (is_clear) ticks.push_back(seconds);
  }
  return ticks;
}

/// To the left of the tick at `tick`, in the middle of its height.
Label TickLabel(double seconds, const Eigen::Vector3d& tick, const TextStyle& style,
                const Eigen::Matrix3d& view_from_map, double meters_per_pixel) {
  const std::string text = fmt::format("{:g} s", seconds);
  const Vector shift =
      meters_per_pixel * Vector(-TextWidth(text, style) - 0.5 * style.size, -0.6 * style.size);
  const Eigen::Vector3d anchor = tick + view_from_map.topRows<2>().transpose() * shift;
  return {anchor.head<2>(), text, anchor.z()};
}

/// A line upwards with the seconds of its ticks beside it.
void DrawAxis(const RisingGraph& graph, const Floor& floor, const Eigen::Matrix3d& view_from_map,
              Sheet* sheet) {
  const Palette& palette = sheet->palette();
  const TextStyle style = TextStyleOf(sheet->size(), palette.dark_label);
  const Vector left = -sheet->Meters(0, 6.0) * view_from_map.row(0).head<2>().transpose();
  Shapes axis;
  axis.AddSlope(floor.axis, 0.0, floor.axis, graph.height(), palette.dark_label);
  std::vector<Label> labels;
  for (const double seconds : VisibleTicks(graph, view_from_map, *sheet)) {
    const double height = graph.scale.meters_per_second * seconds;
    const Vector end = floor.axis + left;
    axis.SetHeight(height);
    axis.AddLine(floor.axis, end, palette.dark_label);
    labels.push_back(TickLabel(seconds, {end.x(), end.y(), height}, style, view_from_map,
                               sheet->camera(0).meters_per_pixel));
  }
  sheet->Add(0, LayerKind::kLabels, [&] {
    return MakeSolidActor(axis.Build(), {sheet->Px(widths::kThin), 1.0, false});
  });
  sheet->Add(0, LayerKind::kLabels,
             [&] { return LabelsLayer(labels, style, WithOpacity(palette.dark_unknown, 0.6)); });
}

}  // namespace

Scene BuildTimeView(DerivedCache* cache, const ViewRequest& request, int oversampling) {
  constexpr double kAzimuth = -30.0;  // [deg]
  constexpr double kElevation = 30.0;
  const SideView side{DegreesToRadians(request.azimuth.value_or(kAzimuth)),
                      DegreesToRadians(request.elevation.value_or(kElevation))};
  const Eigen::Matrix3d view_from_map = side.ViewFromMap();
  const Recording& recording = cache->recording();
  const RisingGraph graph = GraphAfterStep(recording, StepOf(recording, request));
  const std::vector<PlacedGrid> grids = PlacedGridsOf(cache, graph.state);
  const Highlight highlight = HighlightOf(recording, request, graph.state, grids);
  const Floor floor = FloorOf(grids, view_from_map);
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = DarkMapColors(palette);

  Sheet sheet(request, oversampling, Describe(recording, graph),
              KeysOf(colors, palette, highlight));
  const double numbers = 4.5 * sheet.size().font / sheet.frame(0).width;
  sheet.OpenFrom(side, 0, ExtentInView(floor, graph.height(), view_from_map, numbers),
                 colors.unknown,
                 {"seconds since the first scan upwards",
                  fmt::format("azimuth {:g}°", RadiansToDegrees(side.azimuth)),
                  fmt::format("elevation {:g}°", RadiansToDegrees(side.elevation))});
  DrawFloor(floor, colors, &cache->map_composer(), &sheet);
  DrawGraph(graph, &sheet);
  DrawSelection(graph, SelectionOf(highlight), &sheet);
  DrawAxis(graph, floor, view_from_map, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
