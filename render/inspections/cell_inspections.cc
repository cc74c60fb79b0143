// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/slam/cell_history.h"
#include "core/slam/derive.h"
#include "render/inspections/inspections.h"
#include "render/views/selection.h"

namespace loopscope {
namespace {

/// "3 to 5, 9": the nodes of those `writes` that are hits, or misses.
std::string NodesText(const std::vector<CellWrite>& writes, bool hits) {
  std::string text;
  for (std::size_t i = 0; i < writes.size();) {
    if (writes[i].is_hit != hits) {
      ++i;
      continue;
    }
    std::size_t end = i + 1;
    while (end < writes.size() && writes[end].is_hit == hits &&
           writes[end].node.index == writes[end - 1].node.index + 1) {
      ++end;
    }
    const int first = writes[i].node.index;
    const int last = writes[end - 1].node.index;
    text += (text.empty() ? "" : ", ") + std::to_string(first);
    if (last > first) text += fmt::format(" to {}", last);
    i = end;
  }
  return text.empty() ? "none" : text;
}

std::vector<Fact> WritersOf(const std::vector<CellWrite>& writes) {
  return {{"hit by nodes", NodesText(writes, true)}, {"missed by nodes", NodesText(writes, false)}};
}

Fact CellFact(CellIndex cell) { return {"cell", fmt::format("{}, {}", cell.x, cell.y)}; }

struct SubmapThings {
  SubmapId id;
  std::vector<std::pair<NodeId, Eigen::Vector2d>> nodes;  ///< in the frame of the submap
  ProbabilityGrid grid;
  CellHistory history;
};

std::optional<NodeId> NearestNode(const SubmapThings& submap, const Eigen::Vector2d& point,
                                  double tolerance) {
  std::optional<NodeId> nearest;
  double least = tolerance;
  for (const auto& [id, place] : submap.nodes) {
    if ((place - point).norm() > least) continue;
    least = (place - point).norm();
    nearest = id;
  }
  return nearest;
}

std::optional<Finding> FindIn(const SubmapThings& submap, const Eigen::Vector2d& point,
                              double tolerance) {
  Finding finding{NearestNode(submap, point, tolerance), submap.id, {}};
  if (finding.node) finding.facts.push_back({"node", ToString(*finding.node)});
  for (const Fact& fact : CellFacts(submap.grid, point)) finding.facts.push_back(fact);
  const auto writes = submap.history.WritesOf(CellOf(point, submap.grid.resolution()));
  if (writes.empty()) return finding;
  finding.facts.push_back({"odds", OddsText(writes.back().odds)});
  const auto num_hits =
      std::count_if(writes.begin(), writes.end(), [](const CellWrite& w) { return w.is_hit; });
  finding.facts.push_back({"hits", std::to_string(num_hits)});
  finding.facts.push_back({"misses", std::to_string(writes.size() - num_hits)});
  for (const Fact& fact : WritersOf(writes)) finding.facts.push_back(fact);
  return finding;
}

/// The cell as the scan of `node`, the last one in `history`, found and left it.
Finding FindUpdate(const CellHistory& history, NodeId node, SubmapId submap, CellIndex cell) {
  std::vector<CellWrite> writes = history.WritesOf(cell);
  Finding finding{node, submap, {CellFact(cell)}};
  const bool touched = !writes.empty() && writes.back().node == node;
  const std::string what = !touched ? "untouched" : writes.back().is_hit ? "hit" : "miss";
  finding.facts.push_back({"by this scan", what});
  const std::string after = writes.empty() ? "never seen" : OddsText(writes.back().odds);
  const std::vector<Fact> writers = WritersOf(writes);
  if (touched) writes.pop_back();
  const std::string before = writes.empty() ? "never seen" : OddsText(writes.back().odds);
  finding.facts.push_back({"odds before", before});
  finding.facts.push_back({"odds after", after});
  for (const Fact& fact : writers) finding.facts.push_back(fact);
  return finding;
}

}  // namespace

std::string OddsText(double odds) { return fmt::format("{:.3g}", odds); }

std::vector<Fact> CellFacts(const ProbabilityGrid& grid, const Eigen::Vector2d& point) {
  const CellIndex cell = CellOf(point, grid.resolution());
  if (!grid.known(cell)) return {CellFact(cell), {"probability", "never seen"}};
  return {CellFact(cell), {"probability", fmt::format("{:.3f}", grid.probability(cell))}};
}

Look InspectSubmap(const Recording& recording, const ViewRequest& request) {
  const SubmapId id = SubmapOf(recording, request);
  const int num_nodes = NumNodesOfSubmapAfterStep(recording, id, StepOf(recording, request));
  const auto submap = std::make_shared<SubmapThings>(
      SubmapThings{id, {}, GridOfSubmap(recording, id, num_nodes), {recording, id, num_nodes}});
  const NodeId first = recording.submap(id).first_node;
  for (NodeId node = first; node.index < first.index + num_nodes; ++node.index) {
    submap->nodes.emplace_back(node, SubmapFromNode(recording, id, node).translation);
  }
  return [submap](int, const Eigen::Vector2d& point, double tolerance) {
    return FindIn(*submap, point, tolerance);
  };
}

Look InspectUpdate(const Recording& recording, const ViewRequest& request) {
  const NodeId node = NodeOf(recording, request);
  const SubmapId submap = SubmapOfNode(recording, request, node);
  const int num_nodes = node.index - recording.submap(submap).first_node.index + 1;
  const auto history = std::make_shared<CellHistory>(recording, submap, num_nodes);
  const double resolution = recording.options().trajectory_builder_2d.submaps.grid_resolution;
  return [=](int, const Eigen::Vector2d& point, double) -> std::optional<Finding> {
    return FindUpdate(*history, node, submap, CellOf(point, resolution));
  };
}

Look InspectMatch(const Recording& recording, const ViewRequest& request) {
  const auto match = ReplayMatch(recording, StepOf(recording, request));
  if (!match) return [](int, const Eigen::Vector2d&, double) { return std::nullopt; };
  return [submap = match->submap, grid = std::make_shared<ProbabilityGrid>(match->grid)](
             int, const Eigen::Vector2d& point, double) -> std::optional<Finding> {
    return Finding{std::nullopt, submap, CellFacts(*grid, point)};
  };
}

}  // namespace loopscope
