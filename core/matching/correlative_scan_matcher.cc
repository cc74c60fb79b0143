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

/// Of a mean, at most.
constexpr double kRounding = 1e-9;

/// No mean is higher.
constexpr double kHighestMean = kMaxProbability + kRounding;

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

/// The poses of the window, angle by angle from that of the guess on.
class CorrelativeSearch {
 public:
  CorrelativeSearch(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                    const Pose2& submap_from_scan_guess,
                    const CorrelativeScanMatcherOptions& options)
      : grid_(grid),
        options_(options),
        points_(Interleaved(points_in_scan)),
        window_(MakeSearchWindow(points_, submap_from_scan_guess, options.linear_search_window,
                                 options.angular_search_window, grid.resolution())),
        scan_(window_, points_),
        radius_(window_.num_linear_steps),
        best_{submap_from_scan_guess, 0.0} {}
  CorrelativeSearch(const CorrelativeSearch&) = delete;
  CorrelativeSearch& operator=(const CorrelativeSearch&) = delete;

  CorrelativeMatch Run() {
    for (const int angle : FromTheMiddle(window_.num_angular_steps)) {
      const double turn_penalty = DeltaPenalty(0.0, TurnAt(angle), options_);
      if (kHighestMean * turn_penalty <= best_.score) break;
      if (SumPoints(angle, best_.score / turn_penalty)) KeepBestAt(angle);
    }
    return best_;
  }

 private:
  /// [rad] from the guess.
  double TurnAt(int angle) const { return std::abs(angle) * window_.angular_step; }

  /// Sums at all offsets what the grid has at the points; half of them do if these tell that no
  /// mean is more than `mean_to_beat`. Whether one may be.
  bool SumPoints(int angle, double mean_to_beat) {
    const std::vector<CellIndex> cells = scan_.CellsAt(angle);
    const std::size_t num_first = (points_.size() + 1) / 2;
    const std::size_t num_others = points_.size() - num_first;
    sums_.assign((2 * radius_ + 1) * (2 * radius_ + 1), 0);
    AddShifted(grid_, cells.data(), num_first, radius_, sums_.data());
    // At the other points the grid has the highest probability at most.
    const std::uint32_t max_sum =
        *std::max_element(sums_.begin(), sums_.end()) + num_others * StepsAboveMin(kMaxCellValue);
    if (MeanProbability(max_sum, points_.size()) <= mean_to_beat - kRounding) return false;
    AddShifted(grid_, cells.data() + num_first, num_others, radius_, sums_.data());
    return true;
  }

  void KeepBestAt(int angle) {
    const int side = 2 * radius_ + 1;
    for (int k = 0; k < side * side; ++k) {
      const double mean = MeanProbability(sums_[k], points_.size());
      if (mean <= best_.score) continue;  // before any penalty
      const CellIndex offset{k % side - radius_, k / side - radius_};
      const double distance = std::hypot(offset.x, offset.y) * window_.resolution;
      const double score = mean * DeltaPenalty(distance, TurnAt(angle), options_);
      if (score > best_.score) best_ = {PoseInWindow(window_, offset, angle), score};
    }
  }

  const ProbabilityGrid& grid_;
  const CorrelativeScanMatcherOptions& options_;
  PointCloud points_;
  SearchWindow window_;
  TurnedScan scan_;
  int radius_;  ///< of the window [cells]
  std::vector<std::uint32_t> sums_;
  CorrelativeMatch best_;
};

}  // namespace

CorrelativeMatch MatchCorrelative(const PointCloud& points_in_scan, const ProbabilityGrid& grid,
                                  const Pose2& submap_from_scan_guess,
                                  const CorrelativeScanMatcherOptions& options) {
  assert(!points_in_scan.empty());
  return CorrelativeSearch(points_in_scan, grid, submap_from_scan_guess, options).Run();
}

}  // namespace loopscope
