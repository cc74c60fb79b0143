// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/occupancy_map.h"

#include <cmath>
#include <cstdint>
#include <limits>

#include <Eigen/Geometry>

#include "core/grid/probability.h"
#include "core/grid/ray_cast.h"
#include "core/slam/derive.h"

namespace loopscope {
namespace {

constexpr double kHitProbability = 0.7;
constexpr double kMissProbability = 0.4;

constexpr std::int64_t kMaxMapCells = 250000000;  // 1 GB

/// Holds all rays.
Eigen::AlignedBox2d ExtentOfScans(const Recording& recording, const MapState& state) {
  Eigen::AlignedBox2d extent;
  for (int i = 0; i < state.num_nodes; ++i) {
    const RangeData range_data = RangeDataInMap(recording, state, NodeId{i});
    extent.extend(range_data.origin);
    for (const Eigen::Vector2d& point : range_data.returns) extent.extend(point);
    for (const Eigen::Vector2d& point : range_data.misses) extent.extend(point);
  }
  return extent;
}

}  // namespace

OccupancyMap BuildOccupancyMap(const Recording& recording, const MapState& state) {
  OccupancyMap map;
  map.resolution = recording.options().trajectory_builder_2d.submaps.grid_resolution;
  map.box = BoxOfRays(ExtentOfScans(recording, state), map.resolution, kMaxMapCells);
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
    const ScanCells cells = CastRays(RangeDataInMap(recording, state, NodeId{i}), map.resolution);
    observe(cells.hits, kHitProbability);
    observe(cells.misses, kMissProbability);
  }
  for (float& value : values) value = 1.f / (1.f + std::exp(-value));
  return map;
}

}  // namespace loopscope
