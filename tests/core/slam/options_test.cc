// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/options.h"

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "core/slam/option_values.h"

namespace loopscope {
namespace {

// As in configuration_files of Cartographer at 877157a0.
const std::map<std::string, double> kStockNumbers = {
    {"TRAJECTORY_BUILDER_2D.min_range", 0.},
    {"TRAJECTORY_BUILDER_2D.max_range", 30.},
    {"TRAJECTORY_BUILDER_2D.missing_data_ray_length", 5.},
    {"TRAJECTORY_BUILDER_2D.voxel_filter_size", 0.025},
    {"TRAJECTORY_BUILDER_2D.adaptive_voxel_filter.max_length", 0.5},
    {"TRAJECTORY_BUILDER_2D.adaptive_voxel_filter.min_num_points", 200},
    {"TRAJECTORY_BUILDER_2D.adaptive_voxel_filter.max_range", 50.},
    {"TRAJECTORY_BUILDER_2D.loop_closure_adaptive_voxel_filter.max_length", 0.9},
    {"TRAJECTORY_BUILDER_2D.loop_closure_adaptive_voxel_filter.min_num_points", 100},
    {"TRAJECTORY_BUILDER_2D.loop_closure_adaptive_voxel_filter.max_range", 50.},
    {"TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.linear_search_window", 0.1},
    {"TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.angular_search_window", M_PI / 9.},
    {"TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.translation_delta_cost_weight", 0.1},
    {"TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.rotation_delta_cost_weight", 0.1},
    {"TRAJECTORY_BUILDER_2D.ceres_scan_matcher.occupied_space_weight", 1.},
    {"TRAJECTORY_BUILDER_2D.ceres_scan_matcher.translation_weight", 10.},
    {"TRAJECTORY_BUILDER_2D.ceres_scan_matcher.rotation_weight", 40.},
    {"TRAJECTORY_BUILDER_2D.ceres_scan_matcher.ceres_solver_options.max_num_iterations", 20},
    {"TRAJECTORY_BUILDER_2D.motion_filter.max_time_seconds", 5.},
    {"TRAJECTORY_BUILDER_2D.motion_filter.max_distance_meters", 0.2},
    {"TRAJECTORY_BUILDER_2D.motion_filter.max_angle_radians", M_PI / 180.},
    {"TRAJECTORY_BUILDER_2D.submaps.num_range_data", 90},
    {"TRAJECTORY_BUILDER_2D.submaps.grid_options_2d.resolution", 0.05},
    {"TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.probability_grid_range_data_inserter."
     "hit_probability",
     0.55},
    {"TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.probability_grid_range_data_inserter."
     "miss_probability",
     0.49},
    {"POSE_GRAPH.optimize_every_n_nodes", 90},
    {"POSE_GRAPH.constraint_builder.sampling_ratio", 0.3},
    {"POSE_GRAPH.constraint_builder.max_constraint_distance", 15.},
    {"POSE_GRAPH.constraint_builder.min_score", 0.55},
    {"POSE_GRAPH.constraint_builder.global_localization_min_score", 0.6},
    {"POSE_GRAPH.constraint_builder.loop_closure_translation_weight", 1.1e4},
    {"POSE_GRAPH.constraint_builder.loop_closure_rotation_weight", 1e5},
    {"POSE_GRAPH.constraint_builder.fast_correlative_scan_matcher.linear_search_window", 7.},
    {"POSE_GRAPH.constraint_builder.fast_correlative_scan_matcher.angular_search_window",
     M_PI / 6.},
    {"POSE_GRAPH.constraint_builder.fast_correlative_scan_matcher.branch_and_bound_depth", 7},
    {"POSE_GRAPH.constraint_builder.ceres_scan_matcher.occupied_space_weight", 20.},
    {"POSE_GRAPH.constraint_builder.ceres_scan_matcher.translation_weight", 10.},
    {"POSE_GRAPH.constraint_builder.ceres_scan_matcher.rotation_weight", 1.},
    {"POSE_GRAPH.constraint_builder.ceres_scan_matcher.ceres_solver_options.max_num_iterations",
     10},
    {"POSE_GRAPH.matcher_translation_weight", 5e2},
    {"POSE_GRAPH.matcher_rotation_weight", 1.6e3},
    {"POSE_GRAPH.optimization_problem.huber_scale", 1e1},
    {"POSE_GRAPH.optimization_problem.local_slam_pose_translation_weight", 1e5},
    {"POSE_GRAPH.optimization_problem.local_slam_pose_rotation_weight", 1e5},
    {"POSE_GRAPH.optimization_problem.odometry_translation_weight", 1e5},
    {"POSE_GRAPH.optimization_problem.odometry_rotation_weight", 1e5},
    {"POSE_GRAPH.optimization_problem.ceres_solver_options.max_num_iterations", 50},
    {"POSE_GRAPH.max_num_final_iterations", 200},
};

const std::map<std::string, bool> kStockFlags = {
    {"TRAJECTORY_BUILDER_2D.use_online_correlative_scan_matching", false},
    {"TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.probability_grid_range_data_inserter."
     "insert_free_space",
     true},
};

// Not in Cartographer, or in its ROS files only: must do nothing that Cartographer would not.
const std::map<std::string, OptionValue> kOwn = {
    {"use_odometry", true},
    {"TRAJECTORY_BUILDER_2D.recovery.min_relative_score", 0.0},
    {"TRAJECTORY_BUILDER_2D.standstill_min_score_ratio", 0.0},
    {"TRAJECTORY_BUILDER_2D.unusual_motion_min_score_ratio", 0.0},
    {"TRAJECTORY_BUILDER_2D.max_changed_share_at_standstill", 1.0},
    {"TRAJECTORY_BUILDER_2D.recovery.unmeasured_min_relative_score", 0.0},
    {"TRAJECTORY_BUILDER_2D.recovery.max_num_scans_ahead", 0.0},
    {"TRAJECTORY_BUILDER_2D.min_num_matched_points", 0.0},
    {"POSE_GRAPH.constraint_builder.min_relative_score", 0.0},
    {"POSE_GRAPH.constraint_builder.linear_search_window_per_meter", 0.0},
    {"POSE_GRAPH.constraint_builder.angular_search_window_per_meter", 0.0},
    {"POSE_GRAPH.constraint_builder.full_sampling_search_window", 0.0},
    {"POSE_GRAPH.constraint_builder.full_sampling_gap", 0.0},
    {"POSE_GRAPH.constraint_builder.measured_drift.min_window_share", 1.0},
    {"POSE_GRAPH.constraint_builder.ambiguity.max_relative_score", 1.0},
    {"POSE_GRAPH.constraint_builder.consistency.min_num_supporters", 0.0},
    {"POSE_GRAPH.constraint_builder.consistency.good_score_ratio", 0.0},
    {"POSE_GRAPH.constraint_builder.consistency.num_checked_neighbors", 0.0},
    {"TRAJECTORY_BUILDER_2D.odometry_calibration_memory", 0.0},
    {"TRAJECTORY_BUILDER_2D.steady_pace_memory", 0.0},
    {"TRAJECTORY_BUILDER_2D.unmeasured_prior_scale", 1.0},
    {"TRAJECTORY_BUILDER_2D.full_prior_motion", 0.0},
    {"TRAJECTORY_BUILDER_2D.max_correction_between_nodes", 0.0},
    {"TRAJECTORY_BUILDER_2D.velocity_gain", 1.0},
    {"TRAJECTORY_BUILDER_2D.second_prior_relative_score", 0.0},
    {"TRAJECTORY_BUILDER_2D.past_motions_weight", 0.0},
    {"TRAJECTORY_BUILDER_2D.share_beside_walls", 0.0},
    {"TRAJECTORY_BUILDER_2D.recovery.unmeasured_min_score_ratio", 1.0},
    {"TRAJECTORY_BUILDER_2D.recovery.linear_search_window", 1.0},
    {"TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.probability_grid_range_data_inserter."
     "max_wall_gap",
     0.0},
    {"POSE_GRAPH.optimize_every_share", 0.0},
    {"POSE_GRAPH.optimize_at_latest_after_n_nodes", 1e6},
    {"POSE_GRAPH.min_num_held_nodes", 0.0},
    {"POSE_GRAPH.constraint_builder.max_linear_search_window", 30.0},
    {"POSE_GRAPH.constraint_builder.search_window_growth_per_gap", 0.0},
    {"POSE_GRAPH.constraint_builder.unmatched_node_way", 0.0},
    {"POSE_GRAPH.constraint_builder.ambiguity.refuse_at_border", false},
    {"POSE_GRAPH.constraint_builder.wall_sides.max_share_from_behind", 1.0},
    {"POSE_GRAPH.constraint_builder.consistency.min_way", 0.0},
    {"POSE_GRAPH.constraint_builder.second_look.num_nodes", 0.0},
    {"POSE_GRAPH.constraint_builder.second_look.max_unseen_distance", 0.0},
    {"POSE_GRAPH.constraint_builder.last_look.num_nodes", 0.0},
    {"POSE_GRAPH.constraint_builder.last_look.min_score_factor", 1.0},
    {"POSE_GRAPH.constraint_builder.last_look.min_known_share", 1.0},
    {"POSE_GRAPH.optimization_problem.ceres_solver_options.function_tolerance", 1e-6},
    {"POSE_GRAPH.optimization_problem.outliers.max_distance", 0.0},
    {"POSE_GRAPH.optimization_problem.outliers.max_num_rounds", 10.0},
};

TEST(CartographerPreset, HasTheStockValues) {
  Options options = CartographerPreset();
  size_t num_found = 0;
  for (const OptionRow& row : OptionTable(&options)) {
    if (const auto number = kStockNumbers.find(row.key); number != kStockNumbers.end()) {
      EXPECT_NEAR(std::get<double>(GetValue(row)), number->second, 1e-12) << row.key;
    } else if (const auto flag = kStockFlags.find(row.key); flag != kStockFlags.end()) {
      EXPECT_EQ(std::get<bool>(GetValue(row)), flag->second) << row.key;
    } else {
      continue;
    }
    ++num_found;
  }
  EXPECT_EQ(num_found, kStockNumbers.size() + kStockFlags.size());
}

TEST(CartographerPreset, SwitchesOffWhatCartographerHasNot) {
  Options options = CartographerPreset();
  size_t num_found = 0;
  for (const OptionRow& row : OptionTable(&options)) {
    const auto own = kOwn.find(row.key);
    if (own == kOwn.end()) continue;
    EXPECT_EQ(GetValue(row), own->second) << row.key;
    ++num_found;
  }
  EXPECT_EQ(num_found, kOwn.size());
}

TEST(LoopscopePreset, DiffersFromTheStockValuesInWhatIsListedHere) {
  Options ours = LoopscopePreset();
  Options stock = CartographerPreset();
  const auto our_rows = OptionTable(&ours);
  const auto stock_rows = OptionTable(&stock);
  int num_different = 0;
  for (std::size_t i = 0; i < our_rows.size(); ++i) {
    const std::string& key = our_rows[i].key;
    if (GetValue(our_rows[i]) == GetValue(stock_rows[i])) continue;
    EXPECT_EQ(kStockNumbers.count(key) + kStockFlags.count(key) + kOwn.count(key), 1u)
        << key << ": expected what switches it off, or what is stock, in a table above";
    ++num_different;
  }
  EXPECT_GT(num_different, 40);
}

class EveryPreset : public ::testing::TestWithParam<Options (*)()> {};

INSTANTIATE_TEST_SUITE_P(Presets, EveryPreset,
                         ::testing::Values(CartographerPreset, LoopscopePreset));

TEST_P(EveryPreset, IsInRange) {
  Options options = GetParam()();
  for (const OptionRow& row : OptionTable(&options)) {
    EXPECT_NO_THROW(SetValue(GetValue(row), row)) << row.key;
  }
}

}  // namespace
}  // namespace loopscope
