// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/correlative_scan_matcher.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <vector>

#include "core/matching/search_lattice.h"
#include "core/matching/shifted_sums.h"
#include "core/matching/turned_scan.h"

namespace loopscope {
namespace {

/// Of so many cells, whose StepsAboveMin add up to `sum`.
double MeanProbability(std::uint32_t sum, std::size_t num_cells) {
  return kMinProbability + sum * kProbabilityStep / static_cast<double>(num_cells);
}

double DeltaPenalty(double distance, double angle, const CorrelativeScanMatcherOptions& options) {
  const double delta =
      options.translation_delta_cost_weight * distance + options.rotation_delta_cost_weight * angle;
  return std::exp(-delta * delta);
}

/// No mean is higher, even if it was rounded up.
constexpr double kHighestMean = kMaxProbability + 1e-9;

/// Every other point first: these have seen all sides, too.
PointCloud Interleaved(const PointCloud& points) {
  PointCloud interleaved;
  interleaved.reserve(points.size());
  for (const std::size_t first : {0, 1}) {
    for (std::size_t k = first; k < points.size(); k += 2) interleaved.push_back(points[k]);
  }
  return interleaved;
}

/// 0, -1, 1, -2, 2, ..., -last, last.
std::vector<int> FromTheMiddle(int last) {
  std::vector<int> angles = {0};
  for (int angle = 1; angle <= last; ++angle) {
    angles.push_back(-angle);
    angles.push_back(angle);
  }
  return angles;
}

}  // namespace

CorrelativeMatch MatchCorrelative(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                  const Pose2& submap_from_scan_guess,
                                  const CorrelativeScanMatcherOptions& options) {
  assert(!points_in_scan.empty());
  const SearchWindow window =
      MakeSearchWindow(points_in_scan, submap_from_scan_guess, options.linear_search_window,
                       options.angular_search_window, grid.resolution());
  const PointCloud points = Interleaved(points_in_scan);
  const std::size_t num_first = (points.size() + 1) / 2;
  const std::size_t num_others = points.size() - num_first;
  const TurnedScan scan(window, points);
  const int radius = window.num_linear_steps;
  const int side = 2 * radius + 1;
  CorrelativeMatch best{submap_from_scan_guess, 0.0};
  for (const int angle : FromTheMiddle(window.num_angular_steps)) {
    const double turned = std::abs(angle) * window.angular_step;
    const double turn_penalty = DeltaPenalty(0.0, turned, options);
    if (kHighestMean * turn_penalty <= best.score) break;
    const std::vector<CellIndex> cells = scan.CellsAt(angle);
    std::vector<std::uint32_t> sums(side * side, 0);
    AddShifted(grid, cells.data(), num_first, radius, sums.data());
    // At the other points the grid has the highest probability at most.
    const std::uint32_t max_sum =
        *std::max_element(sums.begin(), sums.end()) + num_others * StepsAboveMin(kMaxCellValue);
    if (MeanProbability(max_sum, points.size()) * turn_penalty <= best.score) continue;
    AddShifted(grid, cells.data() + num_first, num_others, radius, sums.data());
    for (int k = 0; k < side * side; ++k) {
      const double mean = MeanProbability(sums[k], cells.size());
      if (mean <= best.score) continue;  // before any penalty
      const CellIndex offset{k % side - radius, k / side - radius};
      const double penalty =
          DeltaPenalty(std::hypot(offset.x, offset.y) * window.resolution, turned, options);
      if (mean * penalty > best.score) best = {PoseInWindow(window, offset, angle), mean * penalty};
    }
  }
  return best;
}

}  // namespace loopscope
