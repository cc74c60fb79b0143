// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/travel_graph.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace loopscope {

void TravelGraph::AddSubmap(double way) {
  edges_.emplace_back();
  last_answer_.reset();
  const int added = static_cast<int>(edges_.size()) - 1;
  if (added > 0) AddEdge(added - 1, added, way);
}

void TravelGraph::AddLoop(SubmapId a, SubmapId b) {
  const auto& edges = edges_[a.index];
  const bool known = std::any_of(edges.begin(), edges.end(), [&](const Edge& edge) {
    return edge.to == b.index && edge.way == 0.0;
  });
  if (!known && a != b) AddEdge(a.index, b.index, 0.0);
}

const std::vector<double>& TravelGraph::WaysFrom(SubmapId from) const {
  if (!last_answer_ || last_answer_->first != from) {
    last_answer_.emplace(from, ShortestWays(from));
  }
  return last_answer_->second;
}

std::vector<double> TravelGraph::ShortestWays(SubmapId from) const {
  // Dijkstra's algorithm.
  std::vector<double> ways(edges_.size(), std::numeric_limits<double>::infinity());
  using Open = std::pair<double, int>;
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  ways[from.index] = 0.0;
  open.push({0.0, from.index});
  while (!open.empty()) {
    const auto [way, submap] = open.top();
    open.pop();
    if (way > ways[submap]) continue;
    for (const Edge& edge : edges_[submap]) {
      if (way + edge.way >= ways[edge.to]) continue;
      ways[edge.to] = way + edge.way;
      open.push({ways[edge.to], edge.to});
    }
  }
  return ways;
}

void TravelGraph::AddEdge(int a, int b, double way) {
  last_answer_.reset();
  edges_[a].push_back({b, way});
  edges_[b].push_back({a, way});
}

}  // namespace loopscope
