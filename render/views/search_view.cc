// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <stdexcept>

#include <fmt/format.h>

#include "core/matching/search_lattice.h"
#include "core/slam/derive.h"
#include "render/layers/hatch.h"
#include "render/layers/outline.h"
#include "render/layers/robot.h"
#include "render/layers/scan.h"
#include "render/layers/search_tree.h"
#include "render/number_text.h"
#include "render/views/close_up.h"
#include "render/views/grids.h"
#include "render/views/search_facts.h"
#include "render/views/selection.h"
#include "render/views/sheet.h"
#include "render/views/views.h"

namespace loopscope {
namespace {

DerivedCache::Search SearchOf(DerivedCache* cache, SubmapId submap, NodeId node) {
  DerivedCache::Search search = cache->SearchOf(submap, node);
  if (search) return search;
  throw std::invalid_argument(fmt::format(
      "node {} cannot be searched in submap {}: expected a finished submap that it is not part of",
      node.index, submap.index));
}

ColorBar BoundBar(const BoundRange& range, double min_score, const Palette& palette) {
  return {"bound of the score",
          palette.bound,
          {{range.PlaceOf(min_score), fmt::format("{:.2f} min", min_score)},
           {1.0, fmt::format("{:.2f}", range.high)},
           {0.0, fmt::format("{:.2f}", range.low)}}};
}

/// How the blocks of the tree look; those that only a part of a search has if `part` is one.
std::vector<LegendEntry> TreeEntries(const SearchPart& part, const Palette& palette) {
  const Color bright = palette.bound.At(0.8);
  const Color dark = WithOpacity(palette.bound.At(0.3), kPrunedOpacity);
  std::vector<LegendEntry> entries{{{Swatch::Kind::kOutline, palette.expanded, bright}, "expanded"},
                                   {{Swatch::Kind::kHatch, dark, palette.paper}, "pruned"}};
  if (!part.filter().num_visits) return entries;
  entries.push_back({{Swatch::Kind::kFill, bright, palette.paper}, "scored, not yet visited"});
  entries.push_back({{Swatch::Kind::kOutline, palette.selection, bright}, "visited last"});
  return entries;
}

/// What refused the winner is shown once the search is over.
bool ShowsRival(const SearchReplay& search, const SearchPart& part) {
  return search.submap_from_rival && !part.filter().num_visits;
}
bool ShowsWalls(const SearchReplay& search, const SearchPart& part) {
  return search.result.verdict == Verdict::kFromBehind && !part.filter().num_visits;
}

LayerKeys KeysOf(const SearchReplay& search, const SearchPart& part, const BoundRange& range,
                 const MapColors& colors, const Palette& palette) {
  const char* const found = part.filter().num_visits   ? "scan at the best so far"
                            : search.trace.winner >= 0 ? "scan at the winner"
                                                       : "scan at the best pose";
  LayerKeys keys{
      {{LayerKind::kScan,
        {{Swatch::Kind::kPoint, palette.prior, colors.free}, "scan where it was expected"}},
       {LayerKind::kScan, {{Swatch::Kind::kPoint, palette.winner, colors.free}, found}},
       {LayerKind::kWindow,
        {{Swatch::Kind::kOutline, palette.window, colors.free}, "search window"}}},
      {{LayerKind::kTree, BoundBar(range, search.result.min_score, palette)}}};
  const auto add_points = [&](const Color& color, const char* label) {
    keys.legend.emplace_back(LayerKind::kScan,
                             LegendEntry{{Swatch::Kind::kPoint, color, colors.free}, label});
  };
  if (ShowsRival(search, part)) add_points(palette.rival, "scan at the rival");
  if (ShowsWalls(search, part)) add_points(palette.from_behind, "on a wall from behind");
  for (LegendEntry& entry : TreeEntries(part, palette)) {
    keys.legend.emplace_back(LayerKind::kTree, std::move(entry));
  }
  return keys;
}

Annotation Describe(const Recording& recording, const SearchReplay& search,
                    const SearchPart& part) {
  Annotation annotation;
  annotation.title = "Search of node " + ToString(search.candidate.node) + " in submap " +
                     ToString(search.candidate.submap);
  annotation.subtitle =
      Subtitle(recording, search.candidate.considered_step,
               {search.recorded ? "as the mapper did" : "not done by the mapper"});
  annotation.facts = FactsOf(search, part, recording.options().pose_graph.constraint_builder);
  return annotation;
}

/// The best pose that was found by then, if any.
std::optional<Pose2> BestPose(const SearchReplay& search, const SearchPart& part) {
  if (!part.filter().num_visits) return search.result.submap_from_node_searched;
  if (part.best_leaf() < 0) return std::nullopt;
  const SearchNode& leaf = search.trace.nodes[part.best_leaf()];
  return PoseInWindow(search.trace.window, leaf.offset, leaf.angle_index);
}

void DrawScan(const SearchReplay& search, const Pose2& submap_from_node, const Color& color,
              int panel, Sheet* sheet) {
  sheet->Add(panel, LayerKind::kScan, [&] {
    return ScanLayer(search.scan.returns, submap_from_node, color, sheet->Px(widths::kScanPoint));
  });
  sheet->Add(panel, LayerKind::kRobot, [&] {
    return RobotLayer(submap_from_node, sheet->Meters(panel, 1.5 * widths::kMark),
                      sheet->Meters(panel, widths::kThin), color);
  });
}

void DrawMap(const SearchReplay& search, const SearchPart& part, const MapColors& colors, int panel,
             Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(panel, LayerKind::kGrid, [&] {
    return CellImageLayer(GridImage(search.grid, colors), Pose2(), search.grid.resolution());
  });
  sheet->Add(panel, LayerKind::kWindow, [&] {
    return OutlineLayer(WindowExtent(search.trace.window), palette.window,
                        sheet->Px(widths::kLine));
  });
  DrawScan(search, search.candidate.submap_from_node_guess, palette.prior, panel, sheet);
  const std::optional<Pose2> best = BestPose(search, part);
  if (best) DrawScan(search, *best, palette.winner, panel, sheet);
  if (ShowsRival(search, part)) {
    DrawScan(search, *search.submap_from_rival, palette.rival, panel, sheet);
  }
  if (!ShowsWalls(search, part)) return;
  sheet->Add(panel, LayerKind::kScan, [&] {
    return ScanLayer(WallsOf(search).from_behind, Pose2(), palette.from_behind,
                     sheet->Px(1.5 * widths::kScanPoint));
  });
}

/// Where most of the scan lies at the best pose, large enough to see how far that is from the
/// guess.
Extent CloseUpOf(const SearchReplay& search, const SearchPart& part) {
  constexpr double kMinSize = 4.0;  // [m]
  constexpr double kSizeInMoves = 3.0;
  const Pose2& guess = search.candidate.submap_from_node_guess;
  const Pose2 best = BestPose(search, part).value_or(guess);
  const double moved = (best.translation - guess.translation).norm();
  std::vector<PointOfInterest> returns;
  for (const Eigen::Vector2d& point : search.scan.returns) returns.push_back({best * point, 1.0});
  return SquareOfMostInterest(returns, std::max(kMinSize, kSizeInMoves * moved));
}

void DrawHatch(const std::vector<Extent>& areas, int panel, Sheet* sheet) {
  sheet->Add(panel, LayerKind::kTree, [&] {
    return HatchLayer(areas, sheet->Meters(panel, widths::kHatch), sheet->palette().hatch,
                      sheet->Px(widths::kHairline));
  });
}

/// A line around `area`, which stays free, that is seen on any colour of the tree.
void DrawMark(const Extent& area, const Color& color, int panel, Sheet* sheet) {
  constexpr double kWidth = widths::kLine;
  constexpr double kEdged = kWidth + 2.0 * widths::kThin;
  const double half = sheet->Meters(panel, 0.5 * kEdged);
  const Extent around(area.min() - Eigen::Vector2d(half, half),
                      area.max() + Eigen::Vector2d(half, half));
  sheet->Add(panel, LayerKind::kTree, [&] {
    return OutlineLayer(around, sheet->palette().selection_edge, sheet->Px(kEdged));
  });
  sheet->Add(panel, LayerKind::kTree,
             [&] { return OutlineLayer(around, color, sheet->Px(kWidth)); });
}

void DrawCircle(const Eigen::Vector2d& center, int panel, Sheet* sheet) {
  sheet->Add(panel, LayerKind::kRobot, [&] {
    return CircleLayer(center, sheet->Meters(panel, 0.7 * widths::kMark), sheet->palette().winner,
                       sheet->Px(widths::kBold));
  });
}

void DrawLevel(const SearchReplay& search, const SearchPart& part, const SearchLevel& level,
               const BoundRange& range, int panel, Sheet* sheet) {
  const Palette& palette = sheet->palette();
  sheet->Add(panel, LayerKind::kTree, [&] { return BlocksLayer(part, level, range, palette); });
  DrawHatch(PrunedBlocks(part, level), panel, sheet);
  sheet->Add(panel, LayerKind::kTree,
             [&] { return ExpandedLayer(part, level, sheet->Px(widths::kHairline), palette); });
  const int last = part.last();
  if (part.Shows(last) && search.trace.nodes[last].height == level.height) {
    DrawMark(BlockOf(search.trace.nodes[last], search.trace.window), palette.selection, panel,
             sheet);
  }
  sheet->Add(panel, LayerKind::kWindow, [&] {
    return OutlineLayer(WindowExtent(search.trace.window), palette.window,
                        sheet->Px(widths::kThin));
  });
  const std::optional<Pose2> best = BestPose(search, part);
  const bool at_angle = !part.filter().angle_index || part.Shows(part.best_leaf());
  if (best && at_angle) DrawCircle(best->translation, panel, sheet);
}

void DrawAngles(const SearchPart& part, const BoundRange& range, Sheet* sheet) {
  const int panel = sheet->num_panels() - 1;
  const SearchTrace& trace = part.trace();
  const SearchWindow& window = trace.window;
  const double degrees = RadiansToDegrees(window.num_angular_steps * window.angular_step);
  const double aspect = sheet->OpenChart(
      panel,
      {fmt::format("by angle, -{0:.1f}° to {0:.1f}°", degrees), "the lowest height at the bottom"});
  const Palette& palette = sheet->palette();
  sheet->Add(panel, LayerKind::kTree, [&] { return AnglesLayer(part, range, aspect, palette); });
  DrawHatch(PrunedFields(part, aspect), panel, sheet);
  if (part.filter().angle_index) {
    DrawMark(ColumnOf(*part.filter().angle_index, trace, aspect), palette.window, panel, sheet);
  }
  if (part.last() >= 0) {
    DrawMark(FieldOf(trace.nodes[part.last()], trace, aspect), palette.selection, panel, sheet);
  }
  if (part.best_leaf() < 0) return;
  DrawCircle(FieldOf(trace.nodes[part.best_leaf()], trace, aspect).center(), panel, sheet);
}

std::vector<std::string> CaptionOf(const SearchPart& part, const SearchLevel& level) {
  std::vector<std::string> caption{
      fmt::format("height {}", level.height),
      fmt::format("{} of {} expanded", level.num_expanded, level.num_scored)};
  if (part.filter().angle_index) {
    const double angle = *part.filter().angle_index * part.trace().window.angular_step;
    caption.insert(caption.begin() + 1, "at " + AngleText(angle));
  }
  return caption;
}

/// One large panel above that of the angles for a single height, else one for each and a close-up,
/// of which two stand above the angles, and more in rows with them.
Arrangement ArrangementOf(const SearchFilter& filter, int num_levels) {
  constexpr double kMainShare = 0.42;
  constexpr int kCaptionRows = 2;
  if (!ShowsCloseUp(filter)) return {num_levels + 1, kMainShare, kCaptionRows, 0.3};
  return {num_levels + 2, kMainShare, kCaptionRows, num_levels == 1 ? 0.5 : 0.0};
}

}  // namespace

Scene BuildSearchView(DerivedCache* cache, const ViewRequest& request, int oversampling) {
  const Recording& recording = cache->recording();
  const auto [submap, node] = SearchedPairOf(recording, request);
  const DerivedCache::Search kept = SearchOf(cache, submap, node);
  const SearchReplay& search = *kept;
  const SearchPart part(search.trace, request.search);
  const std::vector<SearchLevel> levels = LevelsOf(part);
  const BoundRange range = BoundRangeOf(search.trace, search.result.min_score);
  const Palette& palette = PaletteOf(request.theme);
  const MapColors colors = PlainMapColors(palette);

  Sheet sheet(request, oversampling, Describe(recording, search, part),
              KeysOf(search, part, range, colors, palette),
              ArrangementOf(request.search, static_cast<int>(levels.size())));
  Extent extent = ExtentOf(PlacedGrid{{kept, &search.grid}, Pose2()});
  extent.extend(WindowExtent(search.trace.window));
  sheet.Open(0, extent, colors.unknown, {"the submap and the window"});
  DrawMap(search, part, colors, 0, &sheet);
  for (std::size_t i = 0; i < levels.size(); ++i) {
    const int panel = static_cast<int>(i) + 1;
    const Extent blocks = ExtentOfHeight(search.trace, levels[i].height);
    sheet.Open(panel, blocks.merged(WindowExtent(search.trace.window)), palette.paper,
               CaptionOf(part, levels[i]));
    DrawLevel(search, part, levels[i], range, panel, &sheet);
  }
  if (ShowsCloseUp(request.search)) {
    const int panel = static_cast<int>(levels.size()) + 1;
    sheet.Open(panel, CloseUpOf(search, part), colors.unknown, {"where most returns are"});
    DrawMap(search, part, colors, panel, &sheet);
    OutlineCloseUp(panel, &sheet);
  }
  DrawAngles(part, range, &sheet);
  return sheet.Finish();
}

}  // namespace loopscope
