// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/options.h"

namespace loopscope {

Options CartographerPreset() { return Options(); }

Options LoopscopePreset() {
  Options options = CartographerPreset();
  LocalSlamOptions& local = options.trajectory_builder_2d;
  local.use_online_correlative_scan_matching = true;
  local.ceres_scan_matcher.occupied_space_weight = 10.0;
  local.submaps.num_range_data = 40;
  PoseGraphOptions& graph = options.pose_graph;
  graph.optimize_every_n_nodes = 40;
  graph.constraint_builder.min_score = 0.6;
  graph.optimization_problem.huber_scale = 1e2;
  graph.optimization_problem.local_slam_pose_translation_weight = 1e4;
  graph.optimization_problem.local_slam_pose_rotation_weight = 1e4;
  graph.optimization_problem.odometry_translation_weight = 0.0;
  graph.optimization_problem.odometry_rotation_weight = 0.0;
  return options;
}

}  // namespace loopscope
