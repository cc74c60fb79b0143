// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/map_quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include <Eigen/Eigenvalues>

#include "core/evaluation/statistics.h"
#include "core/grid/cell.h"
#include "core/grid/ray_cast.h"
#include "core/slam/derive.h"
#include "core/slam/occupancy_map.h"

namespace loopscope {
namespace {

constexpr double kRadius = 0.3;  // [m]
constexpr int kMinNeighbors = 5;
constexpr std::size_t kMaxQueries = 5000;

/// Finds all points around one.
class Neighborhoods {
 public:
  explicit Neighborhoods(const PointCloud& points) {
    for (const Eigen::Vector2d& point : points) buckets_[KeyOf(point)].push_back(point);
  }

  /// The covariance of the points within kRadius; nothing if they are too few.
  std::optional<Eigen::Matrix2d> CovarianceAround(const Eigen::Vector2d& center) const {
    int count = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d sum_of_squares = Eigen::Matrix2d::Zero();
    Visit(center, [&](const Eigen::Vector2d& offset) {
      ++count;
      sum += offset;
      sum_of_squares += offset * offset.transpose();
    });
    if (count < kMinNeighbors) return std::nullopt;
    return (sum_of_squares - sum * sum.transpose() / count) / (count - 1);
  }

 private:
  using Key = std::pair<int, int>;

  static Key KeyOf(const Eigen::Vector2d& point) {
    const CellIndex cell = CellOf(point, kRadius);
    return {cell.x, cell.y};
  }

  /// Calls `visit` with each point relative to `center`.
  template <typename Function>
  void Visit(const Eigen::Vector2d& center, const Function& visit) const {
    const Key key = KeyOf(center);
    for (int dx = -1; dx <= 1; ++dx) {
      for (int dy = -1; dy <= 1; ++dy) {
        const auto bucket = buckets_.find({key.first + dx, key.second + dy});
        if (bucket == buckets_.end()) continue;
        for (const Eigen::Vector2d& point : bucket->second) {
          const Eigen::Vector2d offset = point - center;
          if (offset.squaredNorm() <= kRadius * kRadius) visit(offset);
        }
      }
    }
  }

  std::map<Key, PointCloud> buckets_;
};

PointCloud ReturnsInMap(const Recording& recording, const MapState& state) {
  PointCloud points;
  for (int i = 0; i < state.num_nodes; ++i) {
    const RangeData range_data = RangeDataInMap(recording, state, NodeId{i});
    points.insert(points.end(), range_data.returns.begin(), range_data.returns.end());
  }
  return points;
}

double DisagreementOf(const Recording& recording, const MapState& state) {
  const OccupancyMap map = BuildOccupancyMap(recording, state);
  const auto is_occupied = [&](CellIndex cell) { return map.probability(cell) > 0.5f; };
  double num_hits = 0.0;
  double num_misses = 0.0;
  for (int i = 0; i < state.num_nodes; ++i) {
    const ScanCells cells = CastRays(RangeDataInMap(recording, state, NodeId{i}), map.resolution);
    num_hits += std::count_if(cells.hits.begin(), cells.hits.end(), is_occupied);
    num_misses += std::count_if(cells.misses.begin(), cells.misses.end(), is_occupied);
  }
  return num_hits > 0.0 ? num_misses / (num_hits + num_misses) : 0.0;
}

}  // namespace

Crispness CrispnessOf(const PointCloud& points) {
  const Neighborhoods neighborhoods(points);
  const std::size_t stride = (points.size() + kMaxQueries - 1) / kMaxQueries;
  std::vector<double> entropies, thicknesses;
  for (std::size_t i = 0; i < points.size(); i += stride) {
    const std::optional<Eigen::Matrix2d> covariance = neighborhoods.CovarianceAround(points[i]);
    if (!covariance || !(covariance->determinant() > 0.0)) continue;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(*covariance,
                                                                Eigen::EigenvaluesOnly);
    entropies.push_back(0.5 * std::log((2.0 * M_PI * M_E * *covariance).determinant()));
    thicknesses.push_back(std::sqrt(std::max(0.0, solver.eigenvalues().x())));
  }
  return {StatisticsOf(entropies).mean, StatisticsOf(thicknesses).median};
}

MapQuality EvaluateMap(const Recording& recording, const MapState& state) {
  return {CrispnessOf(ReturnsInMap(recording, state)), DisagreementOf(recording, state)};
}

}  // namespace loopscope
