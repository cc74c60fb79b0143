// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/search_tree.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace loopscope {
namespace {

/// Whether node `a` says more about its block than `b`.
bool SaysMore(const SearchPart& part, int a, int b) {
  const auto rank = [&](int node) {
    return std::tuple(part.WasExpanded(node), !part.WasPruned(node),
                      part.trace().nodes[node].bound);
  };
  return rank(a) > rank(b);
}

/// Of the `nodes` with the same key, the one that says most, in the order of the keys.
template <typename KeyOf>
std::vector<int> OneForEach(const std::vector<int>& nodes, const SearchPart& part,
                            const KeyOf& key_of) {
  std::map<std::pair<int, int>, int> best;
  for (const int i : nodes) {
    const auto [place, is_new] = best.try_emplace(key_of(part.trace().nodes[i]), i);
    if (!is_new && SaysMore(part, i, place->second)) place->second = i;
  }
  std::vector<int> shown;
  for (const auto& [key, node] : best) shown.push_back(node);
  return shown;
}

Color FillOf(const SearchPart& part, int node, const BoundRange& range, const Palette& palette) {
  const Color color = palette.bound.At(range.PlaceOf(part.trace().nodes[node].bound));
  return part.WasPruned(node) ? WithOpacity(color, kPrunedOpacity) : color;
}

/// From a node to its children, of which the last node is one; more than there are if none was
/// branched.
int HeightsPerBranch(const SearchTrace& trace) {
  if (trace.nodes.empty()) return 1;
  const SearchNode& last = trace.nodes.back();
  return last.parent < 0 ? last.height + 1 : trace.nodes[last.parent].height - last.height;
}

/// A search begins with the highest nodes.
int NumLevels(const SearchTrace& trace) {
  return trace.nodes.empty() ? 1 : trace.nodes.front().height / HeightsPerBranch(trace) + 1;
}

/// Of a field of AnglesLayer.
Eigen::Vector2d FieldSize(const SearchTrace& trace, double aspect) {
  return {aspect / (2 * trace.window.num_angular_steps + 1), 1.0 / NumLevels(trace)};
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

std::vector<SearchLevel> LevelsOf(const SearchPart& part) {
  const SearchTrace& trace = part.trace();
  std::map<int, std::vector<int>, std::greater<>> nodes_at_height;
  for (int i = 0; i < static_cast<int>(trace.nodes.size()); ++i) {
    const int height = trace.nodes[i].height;
    if (part.filter().height && *part.filter().height != height) continue;
    std::vector<int>& nodes = nodes_at_height[height];
    if (part.Shows(i)) nodes.push_back(i);
  }
  std::vector<SearchLevel> levels;
  for (const auto& [height, nodes] : nodes_at_height) {
    SearchLevel level{height, static_cast<int>(nodes.size()), 0, {}};
    for (const int i : nodes) level.num_expanded += part.WasExpanded(i);
    level.shown = OneForEach(nodes, part, [](const SearchNode& node) {
      return std::pair(node.offset.x, node.offset.y);
    });
    levels.push_back(std::move(level));
  }
  return levels;
}

BoundRange BoundRangeOf(const SearchTrace& trace, double min_score) {
  constexpr double kMinWidth = 0.01;
  BoundRange range{min_score, min_score};
  for (const SearchNode& node : trace.nodes) {
    range.low = std::min(range.low, node.bound);
    range.high = std::max(range.high, node.bound);
  }
  range.high = std::max(range.high, range.low + kMinWidth);
  return range;
}

Extent BlockOf(const SearchNode& node, const SearchWindow& window) {
  return PosesExtent(node.offset, 1 << node.height, window);
}

Extent WindowExtent(const SearchWindow& window) {
  const int steps = window.num_linear_steps;
  return PosesExtent({-steps, -steps}, 2 * steps + 1, window);
}

Extent ExtentOfHeight(const SearchTrace& trace, int height) {
  Extent extent;
  for (const SearchNode& node : trace.nodes) {
    if (node.height == height) extent.extend(BlockOf(node, trace.window));
  }
  return extent;
}

vtkSmartPointer<vtkActor> BlocksLayer(const SearchPart& part, const SearchLevel& level,
                                      const BoundRange& range, const Palette& palette) {
  const SearchTrace& trace = part.trace();
  Shapes shapes;
  for (const int i : level.shown) {
    shapes.AddPolygon(CornersOf(BlockOf(trace.nodes[i], trace.window)),
                      FillOf(part, i, range, palette));
  }
  return MakeActor(shapes.Build());
}

std::vector<Extent> PrunedBlocks(const SearchPart& part, const SearchLevel& level) {
  std::vector<Extent> blocks;
  for (const int i : level.shown) {
    if (part.WasPruned(i)) blocks.push_back(BlockOf(part.trace().nodes[i], part.trace().window));
  }
  return blocks;
}

Extent FieldOf(const SearchNode& node, const SearchTrace& trace, double aspect) {
  const Eigen::Vector2d size = FieldSize(trace, aspect);
  const Eigen::Vector2d place(node.angle_index + trace.window.num_angular_steps,
                              node.height / HeightsPerBranch(trace));
  const Eigen::Vector2d min = size.cwiseProduct(place);
  return Extent(min, min + size);
}

Extent ColumnOf(int angle_index, const SearchTrace& trace, double aspect) {
  const double width = FieldSize(trace, aspect).x();
  const double left = width * (angle_index + trace.window.num_angular_steps);
  return Extent(Eigen::Vector2d(left, 0.0), Eigen::Vector2d(left + width, 1.0));
}

std::vector<int> NodesByAngle(const SearchPart& part) {
  std::vector<int> all(part.num_scored());
  std::iota(all.begin(), all.end(), 0);
  return OneForEach(
      all, part, [](const SearchNode& node) { return std::pair(node.angle_index, node.height); });
}

vtkSmartPointer<vtkActor> AnglesLayer(const SearchPart& part, const BoundRange& range,
                                      double aspect, const Palette& palette) {
  Shapes shapes;
  for (const int i : NodesByAngle(part)) {
    shapes.AddPolygon(CornersOf(FieldOf(part.trace().nodes[i], part.trace(), aspect)),
                      FillOf(part, i, range, palette));
  }
  return MakeActor(shapes.Build());
}

std::vector<Extent> PrunedFields(const SearchPart& part, double aspect) {
  std::vector<Extent> fields;
  for (const int i : NodesByAngle(part)) {
    if (part.WasPruned(i)) fields.push_back(FieldOf(part.trace().nodes[i], part.trace(), aspect));
  }
  return fields;
}

vtkSmartPointer<vtkActor> ExpandedLayer(const SearchPart& part, const SearchLevel& level,
                                        double line_width, const Palette& palette) {
  Shapes shapes;
  for (const int i : level.shown) {
    if (!part.WasExpanded(i)) continue;
    shapes.AddOutline(CornersOf(BlockOf(part.trace().nodes[i], part.trace().window)),
                      palette.expanded);
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
