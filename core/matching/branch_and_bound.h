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

/// What makes a pose a rival of the winner: it lies elsewhere, and scores nearly as well.
struct RivalCriterion {
  double min_distance = 0.0;        ///< [m] Rivals are farther from the winner, at any angle
  double min_relative_score = 0.0;  ///< Rivals score more than this share of its score
};

struct SearchOutcome {
  /// The winner; nothing if no pose of the window scores more than min_score.
  std::optional<SearchResult> winner;
  /// Any of its rivals, if they were asked for. Nothing if there is none: then the winner is the
  /// only place where the scan fits.
  std::optional<SearchResult> rival;
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

  /// The same, and then looks for a rival of the winner.
  SearchOutcome SearchWithRival(const PointCloud& points_in_scan,
                                const Pose2& submap_from_scan_guess, double linear_window,
                                double angular_window, double min_score,
                                const RivalCriterion& rival) const;

  /// Searches every place in the submap at every angle.
  SearchOutcome SearchWholeSubmap(const PointCloud& points_in_scan, double min_score,
                                  SearchTrace* trace = nullptr) const;

  /// Of the precomputed grids that searches asked for until now.
  std::size_t num_bytes() const;

 private:
  std::unique_ptr<PrecomputedGrids> grids_;
};

}  // namespace loopscope
