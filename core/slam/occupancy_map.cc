// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/occupancy_map.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "core/grid/probability.h"
#include "core/grid/ray_cast.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

constexpr double kHitProbability = 0.7;
constexpr double kMissProbability = 0.4;

constexpr double kMaxCells = 2.5e8;  // 1 GB

RangeData RangeDataInMap(const Recording& recording, const MapState& state, int node) {
  return Transform(state.global_from_node[node],
                   RangeDataOfStep(recording, recording.nodes()[node].step));
}

/// Holds all rays.
Eigen::AlignedBox2d ExtentOfScans(const Recording& recording, const MapState& state) {
  Eigen::AlignedBox2d extent;
  for (int i = 0; i < state.num_nodes; ++i) {
    const RangeData range_data = RangeDataInMap(recording, state, i);
    extent.extend(range_data.origin);
    for (const Eigen::Vector2d& point : range_data.returns) extent.extend(point);
    for (const Eigen::Vector2d& point : range_data.misses) extent.extend(point);
  }
  return extent;
}

CellBox BoxOf(const Eigen::AlignedBox2d& extent, double resolution) {
  if (extent.isEmpty()) return {};
  const Eigen::Vector2d size = extent.sizes() / resolution;
  if (!((size.x() + 1.0) * (size.y() + 1.0) < kMaxCells)) {
    throw std::runtime_error(
        fmt::format("a map of {:.0f} m x {:.0f} m has more cells of {:g} m than fit in memory",
                    extent.sizes().x(), extent.sizes().y(), resolution));
  }
  const CellIndex min = CellOf(extent.min(), resolution);
  const CellIndex max = CellOf(extent.max(), resolution);
  // One more all around, as CastRays has it against rounding.
  return {{min.x - 1, min.y - 1}, max.x - min.x + 3, max.y - min.y + 3};
}

}  // namespace

OccupancyMap BuildOccupancyMap(const Recording& recording, const MapState& state) {
  OccupancyMap map;
  map.resolution = recording.options().trajectory_builder_2d.submaps.grid_resolution;
  map.box = BoxOf(ExtentOfScans(recording, state), map.resolution);
  std::vector<float>& values = map.probabilities;  // log odds, to begin with
  values.assign(map.box.num_cells(), std::numeric_limits<float>::quiet_NaN());
  const auto observe = [&](const std::vector<CellIndex>& cells, double probability) {
    const auto log_odds = static_cast<float>(std::log(Odds(probability)));
    for (const CellIndex cell : cells) {
      float& value = values[map.box.FlatIndex(cell)];
      value = std::isnan(value) ? log_odds : value + log_odds;
    }
  };
  for (int i = 0; i < state.num_nodes; ++i) {
    const ScanCells cells = CastRays(RangeDataInMap(recording, state, i), map.resolution);
    observe(cells.hits, kHitProbability);
    observe(cells.misses, kMissProbability);
  }
  for (float& value : values) value = 1.f / (1.f + std::exp(-value));
  return map;
}

}  // namespace loopscope
