// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/options.h"

namespace loopscope {

Options CartographerPreset() { return Options(); }

Options LoopscopePreset() {
  Options options = CartographerPreset();
  LocalSlamOptions& local = options.trajectory_builder_2d;
  local.min_num_matched_points = 30;
  local.odometry_calibration_memory = 100.0;
  local.steady_pace_memory = 50;
  local.unmeasured_prior_scale = 2.5;
  local.full_prior_motion = 0.2;
  local.max_correction_between_nodes = 0.03;
  local.use_online_correlative_scan_matching = true;
  local.real_time_correlative_scan_matcher.angular_search_window = DegreesToRadians(20.0);
  // In a corridor the scan fits everywhere: stay where odometry says.
  local.real_time_correlative_scan_matcher.translation_delta_cost_weight = 10.0;
  local.real_time_correlative_scan_matcher.rotation_delta_cost_weight = 3.0;
  local.ceres_scan_matcher.occupied_space_weight = 10.0;
  local.velocity_gain = 0.5;
  local.second_prior_relative_score = 0.8;
  local.max_changed_share_at_standstill = 0.25;
  local.standstill_min_score_ratio = 1.02;
  local.unusual_motion_min_score_ratio = 1.1;
  local.past_motions_weight = 0.05;
  local.share_beside_walls = 0.5;
  local.recovery.min_relative_score = 0.6;
  local.recovery.linear_search_window = 2.0;
  local.recovery.unmeasured_min_relative_score = 0.9;
  local.recovery.unmeasured_min_score_ratio = 1.15;
  local.recovery.max_num_scans_ahead = 8;
  local.submaps.num_range_data = 40;
  local.submaps.range_data_inserter.hit_probability = 0.7;
  local.submaps.range_data_inserter.miss_probability = 0.4;
  local.submaps.range_data_inserter.max_wall_gap = 2.0;

  PoseGraphOptions& graph = options.pose_graph;
  graph.optimize_every_n_nodes = 40;
  graph.optimize_every_share = 0.02;
  graph.optimize_at_latest_after_n_nodes = 300;
  graph.min_num_held_nodes = 5000;
  ConstraintBuilderOptions& loops = graph.constraint_builder;
  loops.max_constraint_distance = 5.0;
  loops.min_score = 0.2;
  loops.min_relative_score = 0.75;
  loops.fast_correlative_scan_matcher.linear_search_window = 1.0;
  loops.fast_correlative_scan_matcher.angular_search_window = DegreesToRadians(5.0);
  loops.linear_search_window_per_meter = 0.021;
  loops.angular_search_window_per_meter = DegreesToRadians(0.02);
  loops.search_window_growth_per_gap = 2.3;
  loops.unmatched_node_way = 100.0;
  loops.max_linear_search_window = 20.0;
  loops.sampling_ratio = 0.6;
  loops.full_sampling_search_window = 4.0;
  loops.full_sampling_gap = 0.5;
  loops.measured_drift.min_window_share = 0.3;
  loops.consistency.min_way = 0.5;
  loops.consistency.num_checked_neighbors = 6;
  loops.second_look.num_nodes = 4;
  loops.second_look.max_unseen_distance = 0.3;
  loops.last_look.num_nodes = 12;
  loops.last_look.min_score_factor = 0.8;
  loops.last_look.min_known_share = 0.35;
  loops.loop_closure_rotation_weight = 1e4;
  loops.wall_sides.max_share_from_behind = 0.15;
  loops.ambiguity.max_relative_score = 0.9;
  loops.ambiguity.refuse_at_border = true;
  loops.consistency.min_num_supporters = 2;
  loops.consistency.good_score_ratio = 1.5;
  graph.optimization_problem.huber_scale = 1e2;
  graph.optimization_problem.local_slam_pose_translation_weight = 1e4;
  graph.optimization_problem.local_slam_pose_rotation_weight = 1e4;
  graph.optimization_problem.odometry_translation_weight = 0.0;
  graph.optimization_problem.odometry_rotation_weight = 0.0;
  graph.optimization_problem.max_num_iterations = 10;
  graph.optimization_problem.function_tolerance = 1e-5;
  graph.optimization_problem.outliers.max_distance = 0.3;
  graph.optimization_problem.outliers.max_num_rounds = 1;
  return options;
}

}  // namespace loopscope
