// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "core/geometry/pose2.h"
#include "core/grid/probability_grid.h"
#include "core/matching/search_trace.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.fast_correlative_scan_matcher.
struct BranchAndBoundOptions {
  double linear_search_window = 7.0;                     ///< W_x = W_y [m]
  double angular_search_window = DegreesToRadians(30.);  ///< W_theta [rad]
  int branch_and_bound_depth = 7;                        ///< number of grids, h_0 + 1
};

struct SearchResult {
  Pose2 submap_from_scan;
  double score = 0.0;  ///< mean of M_nearest (256 steps) at the points, in [0.1, 0.9]
};

struct SearchOutcome {
  /// The winner; nothing if no pose of the window scores more than min_score.
  std::optional<SearchResult> winner;
  /// The best single pose that was scored, the winner or one below min_score.
  SearchResult best_found;
  /// No pose in the window scores more.
  double score_bound = 0.0;
};

class PrecomputedGrids;

/// Branch and bound (Algorithm 3) in one finished submap.
class BranchAndBoundMatcher {
 public:
  /// `depth` is the number of precomputed grids, h_0 + 1; more than 5 are not used.
  BranchAndBoundMatcher(const ProbabilityGrid& grid, int depth);
  ~BranchAndBoundMatcher();

  /// Searches the window of half the width `linear_window` [m] and `angular_window` [rad] around
  /// `submap_from_scan_guess`. `points_in_scan` must not be empty. If `trace` is given, it is
  /// overwritten with every node of the tree that was scored; the parts by which start nodes were
  /// refined are none.
  SearchOutcome Search(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                       double linear_window, double angular_window, double min_score,
                       SearchTrace* trace = nullptr) const;

  /// Any pose of the window of Search that scores more than `min_score` farther than `min_distance`
  /// [m] from `winner`, at any angle. Nothing if there is none: then the winner is the only place
  /// where the scan fits.
  std::optional<SearchResult> FindRival(const PointCloud& points_in_scan,
                                        const Pose2& submap_from_scan_guess, double linear_window,
                                        double angular_window, const Pose2& winner,
                                        double min_distance, double min_score) const;

  /// Searches every place in the submap at every angle.
  SearchOutcome SearchWholeSubmap(const PointCloud& points_in_scan, double min_score,
                                  SearchTrace* trace = nullptr) const;

  /// Of the precomputed grids that searches asked for until now.
  std::size_t num_bytes() const;

 private:
  std::unique_ptr<PrecomputedGrids> grids_;
};

}  // namespace loopscope
