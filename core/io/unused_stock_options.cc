// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/unused_stock_options.h"

#include <utility>

#include "core/geometry/pose2.h"

namespace loopscope {
namespace {

using Stock = std::vector<ConfigEntry>;

void Append(const std::string& prefix, Stock entries, Stock* stock) {
  for (ConfigEntry& entry : entries) {
    stock->push_back({prefix + entry.key, std::move(entry.value)});
  }
}

// Of both trajectory builders.
void AppendExtrapolator(const std::string& builder, Stock* stock) {
  Append(builder, {{"imu_gravity_time_constant", 10.0}}, stock);
  Append(builder + "pose_extrapolator.",
         {
             {"constant_velocity.imu_gravity_time_constant", 10.0},
             {"constant_velocity.pose_queue_duration", 0.001},
             {"imu_based.gravity_constant", 9.806},
             {"imu_based.imu_acceleration_weight", 1.0},
             {"imu_based.imu_rotation_weight", 1.0},
             {"imu_based.odometry_rotation_weight", 1.0},
             {"imu_based.odometry_translation_weight", 1.0},
             {"imu_based.pose_queue_duration", 5.0},
             {"imu_based.pose_rotation_weight", 1.0},
             {"imu_based.pose_translation_weight", 1.0},
             {"imu_based.solver_options.max_num_iterations", 10.0},
             {"imu_based.solver_options.num_threads", 1.0},
             {"imu_based.solver_options.use_nonmonotonic_steps", false},
             {"use_imu_based", false},
         },
         stock);
}

void AppendMapBuilder(Stock* stock) {
  Append("MAP_BUILDER.",
         {
             {"collate_by_trajectory", false},
             {"num_background_threads", 4.0},
             {"use_trajectory_builder_2d", false},
             {"use_trajectory_builder_3d", false},
         },
         stock);
}

void AppendTrajectoryBuilder(Stock* stock) {
  Append("TRAJECTORY_BUILDER.",
         {
             {"collate_fixed_frame", true},
             {"collate_landmarks", false},
         },
         stock);
}

void AppendSubmaps2D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_2D.submaps.range_data_inserter.tsdf_range_data_inserter.",
         {
             {"maximum_weight", 10.0},
             {"normal_estimation_options.num_normal_samples", 4.0},
             {"normal_estimation_options.sample_radius", 0.5},
             {"project_sdf_distance_to_scan_normal", true},
             {"truncation_distance", 0.3},
             {"update_free_space", false},
             {"update_weight_angle_scan_normal_to_ray_kernel_bandwidth", 0.5},
             {"update_weight_distance_cell_to_hit_kernel_bandwidth", 0.5},
             {"update_weight_range_exponent", 0.0},
         },
         stock);
  Append("TRAJECTORY_BUILDER_2D.submaps.",
         {
             {"grid_options_2d.grid_type", "PROBABILITY_GRID"},
             {"range_data_inserter.range_data_inserter_type", "PROBABILITY_GRID_INSERTER_2D"},
         },
         stock);
}

void AppendTrajectoryBuilder2D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_2D.",
         {
             {"ceres_scan_matcher.ceres_solver_options.num_threads", 1.0},
             {"ceres_scan_matcher.ceres_solver_options.use_nonmonotonic_steps", false},
             {"max_z", 2.0},
             {"min_z", -0.8},
             {"num_accumulated_range_data", 1.0},
             {"use_imu_data", true},
         },
         stock);
  AppendExtrapolator("TRAJECTORY_BUILDER_2D.", stock);
  AppendSubmaps2D(stock);
}

void AppendMatchers3D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_3D.real_time_correlative_scan_matcher.",
         {
             {"angular_search_window", DegreesToRadians(1.0)},
             {"linear_search_window", 0.15},
             {"rotation_delta_cost_weight", 0.1},
             {"translation_delta_cost_weight", 0.1},
         },
         stock);
  Append("TRAJECTORY_BUILDER_3D.ceres_scan_matcher.",
         {
             {"ceres_solver_options.max_num_iterations", 12.0},
             {"ceres_solver_options.num_threads", 1.0},
             {"ceres_solver_options.use_nonmonotonic_steps", false},
             {"intensity_cost_function_options_0.huber_scale", 0.3},
             {"intensity_cost_function_options_0.intensity_threshold", 40.0},
             {"intensity_cost_function_options_0.weight", 0.5},
             {"occupied_space_weight_0", 1.0},
             {"occupied_space_weight_1", 6.0},
             {"only_optimize_yaw", false},
             {"rotation_weight", 400.0},
             {"translation_weight", 5.0},
         },
         stock);
}

void AppendFilters3D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_3D.high_resolution_adaptive_voxel_filter.",
         {
             {"max_length", 2.0},
             {"max_range", 15.0},
             {"min_num_points", 150.0},
         },
         stock);
  Append("TRAJECTORY_BUILDER_3D.low_resolution_adaptive_voxel_filter.",
         {
             {"max_length", 4.0},
             {"max_range", 60.0},
             {"min_num_points", 200.0},
         },
         stock);
  Append("TRAJECTORY_BUILDER_3D.motion_filter.",
         {
             {"max_angle_radians", 0.004},
             {"max_distance_meters", 0.1},
             {"max_time_seconds", 0.5},
         },
         stock);
}

void AppendSubmaps3D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_3D.submaps.range_data_inserter.",
         {
             {"hit_probability", 0.55},
             {"intensity_threshold", 40.0},
             {"miss_probability", 0.49},
             {"num_free_space_voxels", 2.0},
         },
         stock);
  Append("TRAJECTORY_BUILDER_3D.submaps.",
         {
             {"high_resolution", 0.1},
             {"high_resolution_max_range", 20.0},
             {"low_resolution", 0.45},
             {"num_range_data", 160.0},
         },
         stock);
}

void AppendTrajectoryBuilder3D(Stock* stock) {
  Append("TRAJECTORY_BUILDER_3D.",
         {
             {"max_range", 60.0},
             {"min_range", 1.0},
             {"num_accumulated_range_data", 1.0},
             {"rotational_histogram_size", 120.0},
             {"use_intensities", false},
             {"use_online_correlative_scan_matching", false},
             {"voxel_filter_size", 0.15},
         },
         stock);
  AppendExtrapolator("TRAJECTORY_BUILDER_3D.", stock);
  AppendMatchers3D(stock);
  AppendFilters3D(stock);
  AppendSubmaps3D(stock);
}

void AppendConstraintBuilder(Stock* stock) {
  Append("POSE_GRAPH.constraint_builder.fast_correlative_scan_matcher_3d.",
         {
             {"angular_search_window", DegreesToRadians(15.0)},
             {"branch_and_bound_depth", 8.0},
             {"full_resolution_depth", 3.0},
             {"linear_xy_search_window", 5.0},
             {"linear_z_search_window", 1.0},
             {"min_low_resolution_score", 0.55},
             {"min_rotational_score", 0.77},
         },
         stock);
  Append("POSE_GRAPH.constraint_builder.ceres_scan_matcher_3d.",
         {
             {"ceres_solver_options.max_num_iterations", 10.0},
             {"ceres_solver_options.num_threads", 1.0},
             {"ceres_solver_options.use_nonmonotonic_steps", false},
             {"occupied_space_weight_0", 5.0},
             {"occupied_space_weight_1", 30.0},
             {"only_optimize_yaw", false},
             {"rotation_weight", 1.0},
             {"translation_weight", 10.0},
         },
         stock);
  Append("POSE_GRAPH.constraint_builder.",
         {
             {"ceres_scan_matcher.ceres_solver_options.num_threads", 1.0},
             {"ceres_scan_matcher.ceres_solver_options.use_nonmonotonic_steps", true},
             {"log_matches", true},
         },
         stock);
}

void AppendPoseGraph(Stock* stock) {
  Append("POSE_GRAPH.optimization_problem.",
         {
             {"acceleration_weight", 110.0},
             {"ceres_solver_options.num_threads", 7.0},
             {"ceres_solver_options.use_nonmonotonic_steps", false},
             {"fix_z_in_3d", false},
             {"fixed_frame_pose_rotation_weight", 100.0},
             {"fixed_frame_pose_tolerant_loss_param_a", 1.0},
             {"fixed_frame_pose_tolerant_loss_param_b", 1.0},
             {"fixed_frame_pose_translation_weight", 10.0},
             {"fixed_frame_pose_use_tolerant_loss", false},
             {"log_solver_summary", false},
             {"rotation_weight", 16000.0},
             {"use_online_imu_extrinsics_in_3d", true},
         },
         stock);
  Append("POSE_GRAPH.",
         {
             {"global_constraint_search_after_n_seconds", 10.0},
             {"global_sampling_ratio", 0.003},
             {"log_residual_histograms", true},
         },
         stock);
  AppendConstraintBuilder(stock);
}

}  // namespace

std::vector<ConfigEntry> UnusedStockOptions() {
  Stock stock;
  AppendMapBuilder(&stock);
  AppendTrajectoryBuilder(&stock);
  AppendTrajectoryBuilder2D(&stock);
  AppendTrajectoryBuilder3D(&stock);
  AppendPoseGraph(&stock);
  return stock;
}

}  // namespace loopscope
