// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include <fmt/format.h>

#include "core/slam/derive.h"
#include "render/inspections/inspections.h"
#include "render/layers/search_tree.h"
#include "render/number_text.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

struct SearchThings {
  SearchThings(DerivedCache::Search replay, const SearchFilter& filter, double chart_aspect)
      : search(std::move(replay)),
        part(search->trace, filter),
        levels(LevelsOf(part)),
        by_angle(NodesByAngle(part)),
        aspect(chart_aspect) {}

  DerivedCache::Search search;
  SearchPart part;  ///< of search->trace
  std::vector<SearchLevel> levels;
  std::vector<int> by_angle;
  double aspect;
};

int NumPosesOf(const SearchNode& node, const SearchWindow& window) {
  const int size = 1 << node.height;
  const auto within = [&](int low) { return std::min(size, window.num_linear_steps - low + 1); };
  return within(node.offset.x) * within(node.offset.y);
}

std::string FateText(const SearchPart& part, int node) {
  if (!part.WasDecided(node)) return "not yet visited";
  switch (part.trace().nodes[node].fate) {
    case SearchFate::kExpanded:
      return "expanded";
    case SearchFate::kImproved:
      return "became the best";
    case SearchFate::kPruned:
      break;
  }
  return "pruned by bound";
}

std::vector<Fact> FactsOf(const SearchPart& part, int index) {
  const SearchTrace& trace = part.trace();
  const SearchNode& node = trace.nodes[index];
  const double r = trace.window.resolution;
  std::vector<Fact> facts{
      {"bound", fmt::format("{:.3f}", node.bound)},
      {"depth", std::to_string(trace.nodes.front().height - node.height)},
      {"height", std::to_string(node.height)},
      {"poses", std::to_string(NumPosesOf(node, trace.window))},
      {"from the guess", fmt::format("{:.2f} m, {:.2f} m", r * node.offset.x, r * node.offset.y)},
      {"angle", AngleText(trace.window.angular_step * node.angle_index)},
      {"fate", FateText(part, index)}};
  if (part.WasDecided(index)) {
    facts.push_back({"best score then", fmt::format("{:.3f}", node.best_before)});
  }
  return facts;
}

/// The first of `nodes` whose area holds `point`.
template <typename AreaOf>
std::optional<Finding> FindBlock(const SearchPart& part, const std::vector<int>& nodes,
                                 const Eigen::Vector2d& point, const AreaOf& area_of) {
  const auto found = std::find_if(nodes.begin(), nodes.end(), [&](int node) {
    return area_of(part.trace().nodes[node]).contains(point);
  });
  if (found == nodes.end()) return std::nullopt;
  return Finding{std::nullopt, std::nullopt, FactsOf(part, *found)};
}

std::optional<Finding> FindIn(const SearchThings& things, int panel, const Eigen::Vector2d& point) {
  const SearchTrace& trace = things.search->trace;
  const int num_levels = static_cast<int>(things.levels.size());
  const bool is_close_up = panel == num_levels + 1 && ShowsCloseUp(things.part.filter());
  if (panel == 0 || is_close_up) {
    return Finding{std::nullopt, things.search->candidate.submap,
                   CellFacts(things.search->grid, point)};
  }
  if (panel <= num_levels) {
    return FindBlock(things.part, things.levels[panel - 1].shown, point,
                     [&](const SearchNode& node) { return BlockOf(node, trace.window); });
  }
  return FindBlock(things.part, things.by_angle, point,
                   [&](const SearchNode& node) { return FieldOf(node, trace, things.aspect); });
}

}  // namespace

Look InspectSearch(DerivedCache* cache, const ViewRequest& request, double aspect) {
  const auto [submap, node] = SearchedPairOf(cache->recording(), request);
  DerivedCache::Search search = cache->SearchOf(submap, node);
  if (!search) return [](int, const Eigen::Vector2d&, double) { return std::nullopt; };
  const auto things =
      std::make_shared<const SearchThings>(std::move(search), request.search, aspect);
  return [things](int panel, const Eigen::Vector2d& point, double) {
    return FindIn(*things, panel, point);
  };
}

}  // namespace loopscope
