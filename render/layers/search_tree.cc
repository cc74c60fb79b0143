// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/search_tree.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace loopscope {
namespace {

bool WasExpanded(const SearchNode& node) { return node.fate != SearchFate::kPruned; }

/// Whether `a` says more about its block than `b`.
bool SaysMore(const SearchNode& a, const SearchNode& b) {
  return std::pair(WasExpanded(a), a.bound) > std::pair(WasExpanded(b), b.bound);
}

/// Of the `nodes` with the same key, the one that says most, in the order of the keys.
template <typename KeyOf>
std::vector<int> OneForEach(const std::vector<int>& nodes, const SearchTrace& trace,
                            const KeyOf& key_of) {
  std::map<std::pair<int, int>, int> best;
  for (const int i : nodes) {
    const auto [place, is_new] = best.try_emplace(key_of(trace.nodes[i]), i);
    if (!is_new && SaysMore(trace.nodes[i], trace.nodes[place->second])) place->second = i;
  }
  std::vector<int> shown;
  for (const auto& [key, node] : best) shown.push_back(node);
  return shown;
}

Color FillOf(const SearchNode& node, const BoundRange& range, const Palette& palette) {
  const Color color = palette.bound.At(range.PlaceOf(node.bound));
  return WasExpanded(node) ? color : WithOpacity(color, kPrunedOpacity);
}

int NumHeights(const SearchTrace& trace) {
  int highest = 0;
  for (const SearchNode& node : trace.nodes) highest = std::max(highest, node.height);
  return highest + 1;
}

/// Of a field of AnglesLayer.
Eigen::Vector2d FieldSize(const SearchTrace& trace, double aspect) {
  return {aspect / (2 * trace.window.num_angular_steps + 1), 1.0 / NumHeights(trace)};
}

std::vector<Eigen::Vector2d> CornersOf(const Extent& extent) {
  return RectangleCorners(Pose2(), extent.min(), extent.max());
}

Extent PosesExtent(const CellIndex& min, int size, const SearchWindow& window) {
  const Eigen::Vector2d half(0.5, 0.5);
  const Eigen::Vector2d low = Eigen::Vector2d(min.x, min.y) - half;
  const Eigen::Vector2d high = low + Eigen::Vector2d(size, size);
  const Eigen::Vector2d& guess = window.submap_from_scan_guess.translation;
  return Extent(guess + window.resolution * low, guess + window.resolution * high);
}

}  // namespace

std::vector<SearchLevel> LevelsOf(const SearchTrace& trace) {
  std::map<int, std::vector<int>, std::greater<>> nodes_at_height;
  for (int i = 0; i < static_cast<int>(trace.nodes.size()); ++i) {
    nodes_at_height[trace.nodes[i].height].push_back(i);
  }
  std::vector<SearchLevel> levels;
  for (const auto& [height, nodes] : nodes_at_height) {
    SearchLevel level;
    level.height = height;
    level.num_scored = static_cast<int>(nodes.size());
    level.num_expanded = static_cast<int>(std::count_if(
        nodes.begin(), nodes.end(), [&](int i) { return WasExpanded(trace.nodes[i]); }));
    level.num_pruned = level.num_scored - level.num_expanded;
    level.shown = OneForEach(nodes, trace, [](const SearchNode& node) {
      return std::pair(node.offset.x, node.offset.y);
    });
    levels.push_back(std::move(level));
  }
  return levels;
}

BoundRange BoundRangeOf(const SearchTrace& trace) {
  if (trace.nodes.empty()) return {};
  const auto [low, high] = std::minmax_element(
      trace.nodes.begin(), trace.nodes.end(),
      [](const SearchNode& a, const SearchNode& b) { return a.bound < b.bound; });
  constexpr double kMinWidth = 0.01;
  return {low->bound, std::max(high->bound, low->bound + kMinWidth)};
}

Extent BlockOf(const SearchNode& node, const SearchWindow& window) {
  return PosesExtent(node.offset, 1 << node.height, window);
}

Extent WindowExtent(const SearchWindow& window) {
  const int steps = window.num_linear_steps;
  return PosesExtent({-steps, -steps}, 2 * steps + 1, window);
}

vtkSmartPointer<vtkActor> BlocksLayer(const SearchTrace& trace, const SearchLevel& level,
                                      const BoundRange& range, const Palette& palette) {
  Shapes shapes;
  for (const int i : level.shown) {
    const SearchNode& node = trace.nodes[i];
    shapes.AddPolygon(CornersOf(BlockOf(node, trace.window)), FillOf(node, range, palette));
  }
  return MakeActor(shapes.Build());
}

Eigen::Vector2d FieldOf(const SearchNode& node, const SearchTrace& trace, double aspect) {
  const Eigen::Vector2d place(node.angle_index + trace.window.num_angular_steps + 0.5,
                              node.height + 0.5);
  return FieldSize(trace, aspect).cwiseProduct(place);
}

vtkSmartPointer<vtkActor> AnglesLayer(const SearchTrace& trace, const BoundRange& range,
                                      double aspect, const Palette& palette) {
  std::vector<int> all(trace.nodes.size());
  std::iota(all.begin(), all.end(), 0);
  const Eigen::Vector2d half = 0.5 * FieldSize(trace, aspect);
  Shapes shapes;
  for (const int i : OneForEach(all, trace, [](const SearchNode& node) {
         return std::pair(node.angle_index, node.height);
       })) {
    const SearchNode& node = trace.nodes[i];
    const Eigen::Vector2d middle = FieldOf(node, trace, aspect);
    shapes.AddPolygon(CornersOf(Extent(middle - half, middle + half)),
                      FillOf(node, range, palette));
  }
  return MakeActor(shapes.Build());
}

vtkSmartPointer<vtkActor> ExpandedLayer(const SearchTrace& trace, const SearchLevel& level,
                                        double line_width, const Palette& palette) {
  Shapes shapes;
  for (const int i : level.shown) {
    const SearchNode& node = trace.nodes[i];
    if (WasExpanded(node)) {
      shapes.AddOutline(CornersOf(BlockOf(node, trace.window)), palette.expanded);
    }
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
