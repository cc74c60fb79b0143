// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include <fmt/format.h>

#include "core/grid/scan_inserter.h"
#include "core/slam/derive.h"
#include "render/layers/robot.h"
#include "render/layers/scan.h"
#include "render/views/close_up.h"
#include "render/views/grids.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

/// What one scan did to one of its submaps, in the frame of the submap.
struct GridUpdate {
  NodeId node;
  SubmapId submap;
  Pose2 submap_from_node;
  RangeData rays;
  ScanCells cells;
  std::vector<CellIndex> changed;  ///< hits and misses
  ProbabilityGrid before;
  ProbabilityGrid after;
};

GridUpdate UpdateOf(const Recording& recording, NodeId node, SubmapId submap) {
  const int num_before = node.index - recording.submap(submap).first_node.index;
  const Pose2 submap_from_node = SubmapFromNode(recording, submap, node);
  const RangeData data = RangeDataOfStep(recording, recording.node(node).step);
  const ProbabilityGrid before = GridOfSubmap(recording, submap, num_before);
  GridUpdate update{node,
                    submap,
                    submap_from_node,
                    Transform(submap_from_node, data),
                    CellsOfNode(recording, submap, node),
                    {},
                    before,
                    before};
  update.changed = update.cells.hits;
  update.changed.insert(update.changed.end(), update.cells.misses.begin(),
                        update.cells.misses.end());
  ScanInserter(recording.options().trajectory_builder_2d.submaps.range_data_inserter)
      .Insert(update.cells, &update.after);
  return update;
}

int NumNew(const GridUpdate& update) {
  int count = 0;
  for (const CellIndex cell : update.changed) count += !update.before.known(cell);
  return count;
}

/// How many of `cells` were thought to be rather occupied, or rather free, before.
int NumThoughtToBe(bool occupied, const std::vector<CellIndex>& cells,
                   const ProbabilityGrid& before) {
  int count = 0;
  for (const CellIndex cell : cells) {
    count += before.known(cell) && (before.probability(cell) > 0.5) == occupied;
  }
  return count;
}

/// Where the odds change most, weighed by the change of the probability.
Extent MostChanged(const GridUpdate& update, double size) {
  std::vector<PointOfInterest> points;
  for (const CellIndex cell : update.changed) {
    const double before = update.before.known(cell) ? update.before.probability(cell) : 0.5;
    points.push_back({CenterOf(cell, update.before.resolution()),
                      std::abs(update.after.probability(cell) - before)});
  }
  return SquareOfMostInterest(points, size);
}

ColorBar OddsBar(const Palette& palette) {
  return {"odds of an obstacle",
          palette.odds,
          {{PlaceOnOddsScale(0.1), "1:9"},
           {PlaceOnOddsScale(0.25), "1:3"},
           {PlaceOnOddsScale(0.5), "1:1"},
           {PlaceOnOddsScale(0.75), "3:1"},
           {PlaceOnOddsScale(0.9), "9:1"}}};
}

LayerKeys KeysOf(const MapColors& colors, const Palette& palette) {
  return {{{LayerKind::kHits, {{Swatch::Kind::kFill, palette.hit, colors.free}, "hit"}},
           {LayerKind::kMisses, {{Swatch::Kind::kFill, palette.miss, colors.free}, "miss"}},
           {LayerKind::kRays, {{Swatch::Kind::kLine, palette.ray, colors.free}, "ray"}},
           {LayerKind::kRobot, {{Swatch::Kind::kRobot, palette.robot, colors.free}, "robot"}},
           {LayerKind::kOdds,
            {{Swatch::Kind::kFill, palette.never_seen, colors.free}, "first seen by this scan"}},
           {LayerKind::kGrid, UnknownEntry(colors)}},
          {{LayerKind::kOdds, OddsBar(palette)}, {LayerKind::kGrid, OccupancyBar(colors)}}};
}

Annotation Describe(const Recording& recording, const GridUpdate& update) {
  const auto& inserter = recording.options().trajectory_builder_2d.submaps.range_data_inserter;
  Annotation annotation;
  annotation.title =
      "Update of submap " + ToString(update.submap) + " by node " + ToString(update.node);
  annotation.subtitle = Subtitle(recording, recording.node(update.node).step, {});
  annotation.facts = {
      {"hits", fmt::format("{} cells", update.cells.hits.size())},
      {"misses", fmt::format("{} cells", update.cells.misses.size())},
      {"first seen", fmt::format("{} cells", NumNew(update))},
      {"hits where free",
       fmt::format("{}", NumThoughtToBe(false, update.cells.hits, update.before))},
      {"misses where occupied",
       fmt::format("{}", NumThoughtToBe(true, update.cells.misses, update.before))},
      {"rays", fmt::format("{}", update.rays.returns.size() + update.rays.misses.size())},
      {"a hit: odds ×", fmt::format("{:.3f}", Odds(inserter.hit_probability))},
      {"a miss: odds ×", fmt::format("{:.3f}", Odds(inserter.miss_probability))}};
  return annotation;
}

Extent ExtentOfCells(const std::vector<CellIndex>& cells, double resolution) {
  Extent extent;
  for (const CellIndex cell : cells) extent.extend(CenterOf(cell, resolution));
  return extent;
}

void DrawCells(const GridUpdate& update, const MapColors& colors, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  const double r = update.before.resolution();
  sheet->Add(0, LayerKind::kGrid,
             [&] { return CellImageLayer(GridImage(update.before, colors), Pose2(), r); });
  sheet->Add(0, LayerKind::kMisses, [&] {
    return CellImageLayer(CellsImage(update.cells.misses, WithOpacity(palette.miss, 0.55)), Pose2(),
                          r);
  });
  sheet->Add(0, LayerKind::kHits, [&] {
    return CellImageLayer(CellsImage(update.cells.hits, palette.hit), Pose2(), r);
  });
  sheet->Add(0, LayerKind::kRays, [&] {
    return RaysLayer(update.rays, WithOpacity(palette.ray, 0.35), sheet->Px(widths::kHairline));
  });
  sheet->Add(0, LayerKind::kRobot, [&] {
    return RobotLayer(update.submap_from_node, sheet->Meters(0, 1.5 * widths::kMark),
                      sheet->Meters(0, widths::kThin), palette.robot);
  });
}

/// Of the cells that the scan observed, over the others as they are.
void DrawOdds(const GridUpdate& update, const ProbabilityGrid& grid, const MapColors& colors,
              int panel, Sheet* sheet) {
  sheet->Add(panel, LayerKind::kGrid,
             [&] { return CellImageLayer(GridImage(grid, colors), Pose2(), grid.resolution()); });
  sheet->Add(panel, LayerKind::kOdds, [&] {
    return CellImageLayer(OddsImage(grid, update.changed, sheet->palette()), Pose2(),
                          grid.resolution());
  });
}

}  // namespace

Scene BuildUpdateView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const NodeId node = NodeOf(recording, request);
  const GridUpdate update = UpdateOf(recording, node, SubmapOfNode(recording, request, node));
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);

  Sheet sheet(request, oversampling, Describe(recording, update), KeysOf(colors, palette), {2});
  const Extent extent = ExtentOfCells(update.changed, update.before.resolution());
  constexpr double kCloseUp = 3.0;  // [m]
  const Extent close_up =
      request.center ? SquareAround(*request.center, kCloseUp) : MostChanged(update, kCloseUp);
  sheet.Open(0, extent, colors.unknown, {"observed"});
  sheet.Open(1, close_up, colors.unknown, {"before"});
  sheet.Open(2, close_up, colors.unknown, {"after"});
  DrawCells(update, colors, &sheet);
  OutlineCloseUp(1, &sheet);
  DrawOdds(update, update.before, colors, 1, &sheet);
  DrawOdds(update, update.after, colors, 2, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
