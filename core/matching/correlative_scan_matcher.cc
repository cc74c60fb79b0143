// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/correlative_scan_matcher.h"

#include <cassert>
#include <cmath>

#include "core/matching/search_lattice.h"

namespace loopscope {
namespace {

double MeanProbability(const std::vector<CellIndex>& cells, CellIndex offset,
                       const ProbabilityGrid& grid) {
  double sum = 0.0;
  for (const CellIndex cell : cells)
    sum += grid.probability({cell.x + offset.x, cell.y + offset.y});
  return sum / static_cast<double>(cells.size());
}

double DeltaPenalty(double distance, double angle, const CorrelativeScanMatcherOptions& options) {
  const double delta =
      options.translation_delta_cost_weight * distance + options.rotation_delta_cost_weight * angle;
  return std::exp(-delta * delta);
}

}  // namespace

CorrelativeMatch MatchCorrelative(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                  const Pose2& submap_from_scan_guess,
                                  const CorrelativeScanMatcherOptions& options) {
  assert(!points_in_scan.empty());
  const SearchWindow window =
      MakeSearchWindow(points_in_scan, submap_from_scan_guess, options.linear_search_window,
                       options.angular_search_window, grid.resolution());
  CorrelativeMatch best{submap_from_scan_guess, 0.0};
  for (int angle = -window.num_angular_steps; angle <= window.num_angular_steps; ++angle) {
    const std::vector<CellIndex> cells = CellsAtAngle(window, points_in_scan, angle);
    for (int y = -window.num_linear_steps; y <= window.num_linear_steps; ++y) {
      for (int x = -window.num_linear_steps; x <= window.num_linear_steps; ++x) {
        const double penalty = DeltaPenalty(std::hypot(x, y) * window.resolution,
                                            std::abs(angle) * window.angular_step, options);
        const double score = MeanProbability(cells, {x, y}, grid) * penalty;
        if (score > best.score) best = {PoseInWindow(window, {x, y}, angle), score};
      }
    }
  }
  return best;
}

}  // namespace loopscope
