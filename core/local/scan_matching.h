// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>

#include "core/grid/probability_grid.h"
#include "core/local/local_slam_options.h"
#include "core/local/match_start.h"
#include "core/matching/motion_prior.h"

namespace loopscope {

struct ScanMatch {
  /// Where (CS) started, if not at the prior: the place that the correlative matcher or the
  /// recovery search found.
  std::optional<Pose2> submap_from_base_correlative;
  Pose2 submap_from_base;  ///< after (CS)
  double score = 0.0;      ///< mean probability at the points there
  MatchStart start = MatchStart::kPrior;
};

/// Where a scan is expected before it is matched.
struct MatchPrior {
  Pose2 submap_from_base;
  bool is_measured = false;  ///< by odometry
  /// Where the robot would be had it gone on as before, if odometry says otherwise.
  std::optional<Pose2> submap_from_base_by_velocity{};
  /// By odometry that did nothing unusual since the last scan that matched.
  bool is_trusted = false;
  /// Whether the robot went so far since the scan before that it may see what is not known yet.
  bool is_far_from_before = false;
  /// [m] Of a measured one, SizeOf the motion since the scan before.
  double motion_size = std::numeric_limits<double>::infinity();
};

/// [m] How far the robot went or, if that is more, a point 2 m away from it was turned.
double SizeOf(const Pose2& motion);

/// Local scan matching: by the correlative matcher, if it is switched on, then (CS). Of these the
/// first that matches well, which is measured by the `expected_score`:
/// 1. around the prior, farther if it was not measured (unmeasured_prior_scale);
/// 2. where the velocity has the robot: then odometry was wrong;
/// 3. at the prior of 1, if that is measured and far from before, and the points in known cells
///    match well;
/// 4. in a wide window around the prior, if that is not trusted; of one that was not measured first
///    nearby;
/// 5. at the prior of 1, if the points in known cells match well;
/// 6. nowhere: the scan stays at the prior, kNone.
ScanMatch MatchScan(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                    const MatchPrior& prior, double expected_score,
                    const LocalSlamOptions& options);

/// Likewise of a scan of whose motion since the scan before, at `submap_from_base_before`, only the
/// `prior` is known: at its most probable pose, then (CS). It is there if it matches badly, too,
/// but as kMotions.
ScanMatch MatchAsBefore(const PointCloud& points_in_base, const ProbabilityGrid& grid,
                        const Pose2& submap_from_base_before, const MotionPrior& prior,
                        double expected_score, const LocalSlamOptions& options);

}  // namespace loopscope
