// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "render/layers/outline.h"
#include "render/layers/robot.h"
#include "render/layers/scan.h"
#include "render/layers/search_tree.h"
#include "render/views/grids.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

SearchReplay SearchOf(const Recording& recording, SubmapId submap, NodeId node) {
  std::optional<SearchReplay> search = ReplaySearch(recording, submap, node);
  if (search) return std::move(*search);
  throw std::invalid_argument(fmt::format(
      "node {} cannot be searched in submap {}: expected a finished submap that it is not part of",
      node.index, submap.index));
}

std::string VerdictText(Verdict verdict) {
  switch (verdict) {
    case Verdict::kTooFar:
      return "too far apart";
    case Verdict::kNotSampled:
      return "not sampled";
    case Verdict::kBelowMinScore:
      return "below min_score";
    case Verdict::kAmbiguous:
      return "fits elsewhere as well";
    case Verdict::kInconsistent:
      return "no other loop agrees";
    case Verdict::kAccepted:
      break;
  }
  return "accepted";
}

double NumPoses(const SearchWindow& window) {
  const double linear = 2.0 * window.num_linear_steps + 1.0;
  return linear * linear * (2.0 * window.num_angular_steps + 1.0);
}

/// How far the search, and then the refinement by (CS), moved the node.
std::vector<Fact> MovesOf(const SearchReplay& search) {
  const LoopCandidate& result = search.result;
  const Pose2 moved =
      search.candidate.submap_from_node_guess.Inverse() * result.submap_from_node_searched;
  std::vector<Fact> facts{{"moved", LengthText(moved.translation.norm())},
                          {"turned left", AngleText(moved.rotation)}};
  if (search.trace.winner < 0) return facts;
  const Pose2 refined = result.submap_from_node_searched.Inverse() * result.submap_from_node;
  facts.push_back({"refined by", LengthText(refined.translation.norm())});
  return facts;
}

std::vector<Fact> FactsOf(const SearchReplay& search) {
  const LoopCandidate& result = search.result;
  const SearchWindow& window = search.trace.window;
  const double num_poses = NumPoses(window);
  const std::size_t num_scored = search.trace.nodes.size();
  // The replay is the search alone: what other loops say of it is in the recording.
  const Verdict verdict = search.recorded ? search.candidate.verdict : result.verdict;
  std::vector<Fact> facts{{"verdict", VerdictText(verdict)},
                          {"best score", fmt::format("{:.3f}", result.score)},
                          {"no pose above", fmt::format("{:.3f}", result.score_bound)},
                          {"min_score", fmt::format("{:.3f}", result.min_score)}};
  if (result.rival_score > 0.0) {
    facts.push_back({"rival score", fmt::format("{:.3f}", result.rival_score)});
  }
  facts.push_back({"nodes that agree", fmt::format("{}", search.candidate.num_supporters)});
  for (const Fact& fact : MovesOf(search)) facts.push_back(fact);
  facts.push_back(
      {"window", fmt::format("±{:.2f} m, ±{:.0f}°", window.num_linear_steps * window.resolution,
                             RadiansToDegrees(window.num_angular_steps * window.angular_step))});
  facts.push_back({"poses in it", CountText(num_poses)});
  facts.push_back(
      {"nodes scored", fmt::format("{} ({:.2g} %)", num_scored, 100.0 * num_scored / num_poses)});
  return facts;
}

ColorBar BoundBar(const BoundRange& range, double min_score, const Palette& palette) {
  ColorBar bar{"bound of the score", palette.bound, {{0.0, fmt::format("{:.2f}", range.low)}}};
  const double place = range.PlaceOf(min_score);
  if (place > 0.0 && place < 1.0) {
    bar.ticks.push_back({place, fmt::format("{:.2f} min", min_score)});
  }
  bar.ticks.push_back({1.0, fmt::format("{:.2f}", range.high)});
  return bar;
}

LayerKeys KeysOf(const SearchReplay& search, const BoundRange& range, const MapColors& colors,
                 const Palette& palette) {
  const char* const found =
      search.trace.winner >= 0 ? "scan at the winner" : "scan at the best pose";
  const Color bright = palette.bound.At(0.8);
  const Color dark = WithOpacity(palette.bound.At(0.3), kPrunedOpacity);
  return {{{LayerKind::kScan,
            {{Swatch::Kind::kPoint, palette.prior, colors.free}, "scan where it was expected"}},
           {LayerKind::kScan, {{Swatch::Kind::kPoint, palette.winner, colors.free}, found}},
           {LayerKind::kWindow,
            {{Swatch::Kind::kOutline, palette.window, colors.free}, "search window"}},
           {LayerKind::kTree, {{Swatch::Kind::kOutline, palette.expanded, bright}, "expanded"}},
           {LayerKind::kTree, {{Swatch::Kind::kFill, dark, palette.paper}, "pruned"}}},
          {{LayerKind::kTree, BoundBar(range, search.result.min_score, palette)}}};
}

Annotation Describe(const Recording& recording, const SearchReplay& search) {
  Annotation annotation;
  annotation.title = "Search of node " + ToString(search.candidate.node) + " in submap " +
                     ToString(search.candidate.submap);
  annotation.subtitle =
      Subtitle(recording, search.candidate.considered_step,
               {search.recorded ? "as the mapper did" : "not done by the mapper"});
  annotation.facts = FactsOf(search);
  return annotation;
}

Extent ExtentOfLevel(const SearchTrace& trace, const SearchLevel& level) {
  Extent extent;
  for (const int i : level.shown) extent.extend(BlockOf(trace.nodes[i], trace.window));
  return extent;
}

void DrawMap(const SearchReplay& search, const MapColors& colors, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(0, LayerKind::kGrid, [&] {
    return CellImageLayer(GridImage(search.grid, colors), Pose2(), search.grid.resolution());
  });
  sheet->Add(0, LayerKind::kWindow, [&] {
    return OutlineLayer(WindowExtent(search.trace.window), palette.window,
                        sheet->Px(widths::kLine));
  });
  const std::pair<Pose2, Color> places[] = {
      {search.candidate.submap_from_node_guess, palette.prior},
      {search.result.submap_from_node_searched, palette.winner}};
  for (const auto& [submap_from_node, color] : places) {
    sheet->Add(0, LayerKind::kScan, [&, pose = submap_from_node, c = color] {
      return ScanLayer(search.points, pose, c, sheet->Px(widths::kScanPoint));
    });
    sheet->Add(0, LayerKind::kRobot, [&, pose = submap_from_node, c = color] {
      return RobotLayer(pose, sheet->Meters(0, 1.5 * widths::kMark),
                        sheet->Meters(0, widths::kThin), c);
    });
  }
}

void DrawLevel(const SearchReplay& search, const SearchLevel& level, const BoundRange& range,
               int panel, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(panel, LayerKind::kTree,
             [&] { return BlocksLayer(search.trace, level, range, palette); });
  sheet->Add(panel, LayerKind::kTree, [&] {
    return ExpandedLayer(search.trace, level, sheet->Px(widths::kHairline), palette);
  });
  sheet->Add(panel, LayerKind::kWindow, [&] {
    return OutlineLayer(WindowExtent(search.trace.window), palette.window,
                        sheet->Px(widths::kThin));
  });
  sheet->Add(panel, LayerKind::kRobot, [&] {
    return CircleLayer(search.result.submap_from_node_searched.translation,
                       sheet->Meters(panel, 0.7 * widths::kMark), palette.winner,
                       sheet->Px(widths::kBold));
  });
}

void DrawAngles(const SearchReplay& search, const BoundRange& range, Sheet* sheet) {
  const int panel = sheet->num_panels() - 1;
  const SearchTrace& trace = search.trace;
  const SearchWindow& window = trace.window;
  const double degrees = RadiansToDegrees(window.num_angular_steps * window.angular_step);
  const double aspect = sheet->OpenChart(
      panel, {fmt::format("by angle, -{0:.0f}° to {0:.0f}°", degrees), "height 0 at the bottom"});
  const Palette& palette = sheet->palette();
  sheet->Add(panel, LayerKind::kTree, [&] { return AnglesLayer(trace, range, aspect, palette); });
  if (trace.winner < 0) return;
  sheet->Add(panel, LayerKind::kRobot, [&] {
    const Eigen::Vector2d field = FieldOf(trace.nodes[trace.winner], trace, aspect);
    return CircleLayer(field, sheet->Meters(panel, 0.7 * widths::kMark), palette.winner,
                       sheet->Px(widths::kBold));
  });
}

}  // namespace

Scene BuildSearchView(const Recording& recording, const ViewRequest& request, int oversampling) {
  const auto [submap, node] = SearchedPairOf(recording, request);
  const SearchReplay search = SearchOf(recording, submap, node);
  const std::vector<SearchLevel> levels = LevelsOf(search.trace);
  const BoundRange range = BoundRangeOf(search.trace);
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);

  Sheet sheet(request, oversampling, Describe(recording, search),
              KeysOf(search, range, colors, palette),
              {static_cast<int>(levels.size()) + 1, 0.42, 2});
  PlacedGrid grid{std::make_shared<ProbabilityGrid>(search.grid), Pose2()};
  Extent extent = ExtentOf(grid);
  extent.extend(WindowExtent(search.trace.window));
  sheet.Open(0, extent, colors.unknown, {"the submap and the window"});
  DrawMap(search, colors, &sheet);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int panel = static_cast<int>(i) + 1;
    const SearchLevel& level = levels[i];
    sheet.Open(panel, ExtentOfLevel(search.trace, level), palette.paper,
               {fmt::format("height {}", level.height),
                fmt::format("{} of {} expanded", level.num_expanded, level.num_scored)});
    DrawLevel(search, level, range, panel, &sheet);
  }
  DrawAngles(search, range, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
