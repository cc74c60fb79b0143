// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/plain_scan_insertion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace loopscope {
namespace {

using Cells = std::set<PlainGrid::Cell>;

double Odds(double p) { return p / (1.0 - p); }

PlainGrid::Cell CellAt(const Eigen::Vector2d& place_in_cells) {
  return {static_cast<int>(std::floor(place_in_cells.x())),
          static_cast<int>(std::floor(place_in_cells.y()))};
}

void WalkRay(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Cells* crossed) {
  const Eigen::Vector2d way = to - from;
  auto [x, y] = CellAt(from);
  const PlainGrid::Cell last = CellAt(to);
  const int step_x = way.x() > 0.0 ? 1 : -1;
  const int step_y = way.y() > 0.0 ? 1 : -1;
  const auto until = [](double at, int cell, double along) {
    if (along == 0.0) return std::numeric_limits<double>::infinity();
    return (cell + (along > 0.0 ? 1 : 0) - at) / along;
  };
  const int num_steps = std::abs(last.first - x) + std::abs(last.second - y);
  crossed->insert({x, y});
  for (int i = 0; i < num_steps; ++i) {
    if (until(from.x(), x, way.x()) < until(from.y(), y, way.y())) {
      x += step_x;
    } else {
      y += step_y;
    }
    crossed->insert({x, y});
  }
}

}  // namespace

void PlainGrid::Insert(const RangeData& data, double hit_probability, double miss_probability) {
  const auto in_cells = [this](const Eigen::Vector2d& point) -> Eigen::Vector2d {
    return point / resolution_ + Eigen::Vector2d(0.5, 0.5);
  };
  Cells hits;
  Cells misses;
  for (const Eigen::Vector2d& point : data.returns) {
    hits.insert(CellAt(in_cells(point)));
    WalkRay(in_cells(data.origin), in_cells(point), &misses);
  }
  for (const Eigen::Vector2d& point : data.misses) {
    WalkRay(in_cells(data.origin), in_cells(point), &misses);
  }
  const auto observe = [this](const Cell& cell, double probability) {
    const auto [entry, is_new] = probabilities_.emplace(cell, probability);
    if (is_new) return;
    const double odds = Odds(entry->second) * Odds(probability);
    entry->second = std::clamp(odds / (1.0 + odds), 0.1, 0.9);
  };
  for (const Cell& cell : hits) observe(cell, hit_probability);
  for (const Cell& cell : misses) {
    if (hits.count(cell) == 0) observe(cell, miss_probability);
  }
}

}  // namespace loopscope
