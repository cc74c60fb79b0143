// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/unused_options.h"

#include "core/io/unused_stock_options.h"

namespace loopscope {
namespace {

// Of cartographer_ros: names of frames and topics, and periods.
constexpr const char* kWithoutEffect[] = {
    "map_frame",
    "tracking_frame",
    "published_frame",
    "odom_frame",
    "provide_odom_frame",
    "publish_frame_projected_to_2d",
    "publish_to_tf",
    "publish_tracked_pose",
    "use_pose_extrapolator",
    "ignore_out_of_order",
    "num_laser_scans",
    "num_multi_echo_laser_scans",
    "num_point_clouds",
    "num_subdivisions_per_laser_scan",
    "lookup_transform_timeout_sec",
    "submap_publish_period_sec",
    "pose_publish_period_sec",
    "trajectory_publish_period_sec",
};

// Read by cartographer_ros, or by Cartographer where a file sets them.
std::vector<UnusedOption> OptionsBesideStockFiles() {
  return {
      {"use_nav_sat", false},
      {"use_landmarks", false},
      {"rangefinder_sampling_ratio", 1.0},
      {"odometry_sampling_ratio", 1.0},
      {"fixed_frame_pose_sampling_ratio", 1.0},
      {"imu_sampling_ratio", 1.0},
      {"landmarks_sampling_ratio", 1.0},
      {"POSE_GRAPH.overlapping_submaps_trimmer_2d.fresh_submaps_count", std::nullopt},
      {"POSE_GRAPH.overlapping_submaps_trimmer_2d.min_covered_area", std::nullopt},
      {"POSE_GRAPH.overlapping_submaps_trimmer_2d.min_added_submaps_count", std::nullopt},
      {"TRAJECTORY_BUILDER.pure_localization", std::nullopt},
      {"TRAJECTORY_BUILDER.pure_localization_trimmer.max_submaps_to_keep", std::nullopt},
  };
}

}  // namespace

std::vector<UnusedOption> UnusedOptions() {
  std::vector<UnusedOption> options = OptionsBesideStockFiles();
  for (const char* key : kWithoutEffect) options.push_back({key, std::nullopt, false});
  for (auto& [key, value] : UnusedStockOptions()) {
    const bool runs_only = key.find("num_threads") != std::string::npos ||
                           key.find("log_") != std::string::npos ||
                           key.rfind("MAP_BUILDER.", 0) == 0;
    options.push_back({key, std::move(value), !runs_only});
  }
  return options;
}

}  // namespace loopscope
