// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "render/layers/robot.h"
#include "render/layers/scan.h"
#include "render/number_text.h"
#include "render/views/close_up.h"
#include "render/views/grids.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

/// The scan at one of its poses.
struct ScanPlace {
  Pose2 submap_from_base;
  Color color;
  std::string label;
};

std::vector<ScanPlace> PlacesOf(const MatchReplay& match, const Palette& palette) {
  std::vector<ScanPlace> places{{match.submap_from_base_prior, palette.prior, "predicted"}};
  if (match.submap_from_base_correlative) {
    places.push_back(
        {*match.submap_from_base_correlative, palette.correlative, "correlative match"});
  }
  places.push_back({match.submap_from_base, palette.refined, "refined"});
  return places;
}

LayerKeys KeysOf(const std::vector<ScanPlace>& places, const MapColors& colors) {
  LayerKeys keys;
  for (const ScanPlace& place : places) {
    keys.legend.push_back(
        {LayerKind::kScan, {{Swatch::Kind::kPoint, place.color, colors.free}, place.label}});
  }
  keys.legend.push_back({LayerKind::kGrid, UnknownEntry(colors)});
  keys.color_bars = {{LayerKind::kGrid, OccupancyBar(colors)}};
  return keys;
}

Annotation Describe(const Recording& recording, int step, const MatchReplay& match) {
  const Pose2 correction = match.submap_from_base_prior.Inverse() * match.submap_from_base;
  const std::optional<NodeId> node = recording.step(step).node;
  Annotation annotation;
  annotation.title =
      "Match of the scan of step " + std::to_string(step) + " in submap " + ToString(match.submap);
  annotation.subtitle =
      Subtitle(recording, step, {node ? "node " + ToString(*node) : std::string("not inserted")});
  annotation.facts = {{"moved ahead", LengthText(correction.x())},
                      {"moved left", LengthText(correction.y())},
                      {"turned left", AngleText(correction.rotation)},
                      {"score predicted", fmt::format("{:.3f}", match.prior_score)},
                      {"score refined", fmt::format("{:.3f}", match.score)},
                      {"points", fmt::format("{}", match.points.size())}};
  if (match.wide_walls) annotation.facts.push_back({"walls", "a cell wider"});
  const MatchStart start = recording.step(step).match_start.value_or(MatchStart::kPrior);
  if (start != MatchStart::kPrior) annotation.facts.push_back({"match began", ToString(start)});
  return annotation;
}

/// How far the correction moves each point, by its refined place.
std::vector<PointOfInterest> MovesOf(const MatchReplay& match) {
  std::vector<PointOfInterest> moves;
  for (const Eigen::Vector2d& point : match.points) {
    const Eigen::Vector2d refined = match.submap_from_base * point;
    moves.push_back({refined, (refined - match.submap_from_base_prior * point).norm()});
  }
  return moves;
}

/// The edge [m] of a square in which a move of `length` is well seen.
double CloseUpSize(double length, double min_size) { return std::max(min_size, 8.0 * length); }

double LargestWeight(const std::vector<PointOfInterest>& points) {
  double largest = 0.0;
  for (const PointOfInterest& point : points) largest = std::max(largest, point.weight);
  return largest;
}

Extent ExtentOfScan(const MatchReplay& match) {
  Extent extent(match.submap_from_base.translation);
  for (const Eigen::Vector2d& point : Transform(match.submap_from_base, match.points)) {
    extent.extend(point);
  }
  return extent;
}

void DrawPanel(const MatchReplay& match, const std::vector<ScanPlace>& places,
               const MapColors& colors, double point_size, int panel, Sheet* sheet) {
  sheet->Add(panel, LayerKind::kGrid, [&] {
    return CellImageLayer(GridImage(match.grid, colors), Pose2(), match.grid.resolution());
  });
  for (const ScanPlace& place : places) {
    sheet->Add(panel, LayerKind::kScan, [&] {
      return ScanLayer(match.points, place.submap_from_base, place.color, sheet->Px(point_size));
    });
    sheet->Add(panel, LayerKind::kRobot, [&] {
      return RobotLayer(place.submap_from_base, sheet->Meters(panel, 1.5 * widths::kMark),
                        sheet->Meters(panel, 0.5 * widths::kThin), place.color);
    });
  }
  sheet->Add(panel, LayerKind::kResiduals, [&] {
    return MovesLayer(match.points, match.submap_from_base_prior, match.submap_from_base,
                      sheet->palette().refined, sheet->Px(widths::kThin));
  });
}

MatchReplay MatchOfStep(const Recording& recording, int step) {
  std::optional<MatchReplay> match = ReplayMatch(recording, step);
  if (match) return *match;
  throw NothingToShow(
      fmt::format("the scan of step {} was not matched: expected one after the first insertion "
                  "with returns in range",
                  step));
}

}  // namespace

Scene BuildMatchView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const int step = StepOf(recording, request);
  const MatchReplay match = MatchOfStep(recording, step);
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);
  const std::vector<ScanPlace> places = PlacesOf(match, palette);

  Sheet sheet(request, oversampling, Describe(recording, step, match), KeysOf(places, colors), {2});
  const std::vector<PointOfInterest> moves = MovesOf(match);
  const Extent wall = SquareOfMostInterest(moves, CloseUpSize(LargestWeight(moves), 1.0));
  const Eigen::Vector2d& robot = match.submap_from_base.translation;
  const double moved = (robot - match.submap_from_base_prior.translation).norm();
  sheet.Open(0, ExtentOfScan(match), colors.unknown, {"over the submap"});
  sheet.Open(1, wall, colors.unknown, {"close-up", "where it moved most"});
  sheet.Open(2, SquareAround(robot, CloseUpSize(moved, 0.1)), colors.unknown, {"robot"});
  DrawPanel(match, places, colors, widths::kScanPoint, 0, &sheet);
  DrawPanel(match, places, colors, 2.5 * widths::kScanPoint, 1, &sheet);
  DrawPanel(match, places, colors, 2.5 * widths::kScanPoint, 2, &sheet);
  OutlineCloseUp(1, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
