// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/local/active_submaps.h"
#include "core/local/motion_filter.h"
#include "core/matching/correlative_scan_matcher.h"
#include "core/matching/scan_match_refinement.h"
#include "core/sensor/range_data.h"
#include "core/sensor/voxel_filter.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.recovery, not in Cartographer: a wide search in the active submap for a
/// scan that matches badly, as after a jump of odometry.
struct RecoveryOptions {
  /// Search if the mean probability at the points is below this share of what the scans before had
  /// on average; 0: never.
  double min_relative_score = 0.0;
  /// Likewise where no odometry predicted the scan; any gain is taken then.
  double unmeasured_min_relative_score = 0.0;
  double unmeasured_linear_search_window = 1.0;  ///< [m] where it is looked for first
  double unmeasured_angular_search_window = DegreesToRadians(30.0);  ///< [rad] likewise
  /// What lies beyond that window must score this many times as much as all in it.
  double unmeasured_min_score_ratio = 1.0;
  double min_gain = 0.2;  ///< take what was found if its mean probability is higher by this much
  double linear_search_window = 1.0;                      ///< [m]
  double angular_search_window = DegreesToRadians(90.0);  ///< [rad]
  /// A scan that odometry predicted and that matches nowhere waits for one of so many after it that
  /// does: the jump there is shared among all of them; 0: none is waited for.
  int max_num_scans_ahead = 0;
};

/// TRAJECTORY_BUILDER_2D. Defaults here and in the parts are Cartographer's.
struct LocalSlamOptions {
  RangeOptions range;
  double voxel_filter_size = 0.025;  ///< [m]
  AdaptiveVoxelFilterOptions adaptive_voxel_filter{0.5, 200, 50.0};
  /// A scan with fewer points stays where it is predicted; not in Cartographer. In the open a
  /// handful of points matches anywhere.
  int min_num_matched_points = 0;
  AdaptiveVoxelFilterOptions loop_closure_adaptive_voxel_filter{0.9, 100, 50.0};
  bool use_online_correlative_scan_matching = false;
  CorrelativeScanMatcherOptions real_time_correlative_scan_matcher;
  CeresScanMatcherOptions ceres_scan_matcher;
  RecoveryOptions recovery;
  MotionFilterOptions motion_filter;
  SubmapsOptions submaps;
  bool use_odometry = true;  ///< whether odometry, where there is any, predicts the motion
  /// [m] Way over which it is learned how far odometry moves, and to which side of the scanner; 0:
  /// not at all. Not in Cartographer.
  double odometry_calibration_memory = 0.0;
  /// Number of scans over which it is learned whether stamps tell how far the robot went; 0: they
  /// do. For scans without odometry; not in Cartographer.
  int steady_pace_memory = 0;
  /// Share of the last motion in the velocity that predicts the next one where there is no
  /// odometry; the rest is the velocity before. Not in Cartographer. Where little tells how far the
  /// robot went, a velocity that follows each match runs away.
  double velocity_gain = 1.0;
  /// A scan that matches less than this share of what those before had on average, where odometry
  /// puts it, is also matched where the velocity does; 0: never. Not in Cartographer.
  double second_prior_relative_score = 0.0;
  /// Odometry that measured no motion hangs, and is not used, if more than this share of what the
  /// scanner sees changed meanwhile; 1: it never does. Not in Cartographer.
  double max_changed_share_at_standstill = 1.0;
  /// Where odometry stands still, a scan is also matched as if there were none, and believed there
  /// if it scores this many times as much; 0: never. Not in Cartographer. Odometry may hang.
  double standstill_min_score_ratio = 0.0;
  /// Odometry may jump. Where it measured a motion that it hardly ever measures (UsualMotion) or
  /// that is like none of PastMotions, and the scan matches there by less than 80 % of what is
  /// expected, or where the scan matches nowhere, it is also matched as if there were no odometry.
  /// It is believed there if it and the three scans ahead score this many times as much; 0: never.
  /// Not in Cartographer.
  double unusual_motion_min_score_ratio = 0.0;
  /// Where neither odometry predicts a scan nor, for scans are sparse, the velocity, the score of a
  /// pose is multiplied by the likelihood of the motion to it, judged by those before
  /// (MotionPrior), to this power; 0: the velocity predicts all scans. Not in Cartographer.
  double past_motions_weight = 0.0;
  /// Scans that are far apart, or without odometry, are matched with a grid whose walls are a cell
  /// wider to all sides, where they stand for this share; 0: with the grid as it is. Not in
  /// Cartographer. See WithWideWalls.
  double share_beside_walls = 0.0;
  /// A pose that no odometry predicted is looked for in windows this many times as large, and its
  /// deviation from the prediction weighs as much less. Not in Cartographer.
  double unmeasured_prior_scale = 1.0;
  /// [m] A scan before which odometry measured less (see SizeOf) is held at the place that it
  /// predicts by a weight that is larger in inverse proportion, up to 2.5 times; 0: by the same.
  /// Not in Cartographer.
  double full_prior_motion = 0.0;
  /// [m] Odometry predicts a scan from the last one that was inserted, not from the scan before it,
  /// until a match corrects it by more (see SizeOf); 0: from the scan before. Each match pulls a
  /// scan to the cells that were hit before, and along a corridor that would add up the more, the
  /// more often scans come. Not in Cartographer.
  double max_correction_between_nodes = 0.0;
};

}  // namespace loopscope
