// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/option_table.h"

#include <utility>

namespace loopscope {
namespace {

using Rows = std::vector<OptionRow>;

constexpr double kPi = 3.141592653589793;
constexpr double kMaxLength = 1e3;  // [m]
constexpr double kMaxWindow = 100;  // [m]
constexpr double kMaxWeight = 1e9;
constexpr double kMaxCount = 1e6;

void Append(const std::string& prefix, Rows rows, Rows* table) {
  for (OptionRow& row : rows) {
    row.key = prefix + row.key;
    table->push_back(std::move(row));
  }
}

Rows RangeRows(RangeOptions* o) {
  return {
      {"min_range", &o->min_range, 0, kMaxLength, "m", "Nearer readings are dropped."},
      {"max_range", &o->max_range, 0.1, kMaxLength, "m", "Farther readings become misses."},
      {"missing_data_ray_length", &o->missing_data_ray_length, 0, kMaxLength, "m",
       "How far the ray of a reading beyond max_range is taken to be free."},
  };
}

Rows AdaptiveVoxelFilterRows(AdaptiveVoxelFilterOptions* o) {
  return {
      {"max_length", &o->max_length, 0.01, 10, "m", "Edge of the coarsest voxel tried."},
      {"min_num_points", &o->min_num_points, 1, kMaxCount, "",
       "The voxel is made smaller until so many points are left."},
      {"max_range", &o->max_range, 0.1, kMaxLength, "m", "Points farther away are dropped."},
  };
}

Rows CorrelativeScanMatcherRows(CorrelativeScanMatcherOptions* o) {
  return {
      {"linear_search_window", &o->linear_search_window, 0, 10, "m",
       "Poses so far from the guess in x and y are tried."},
      {"angular_search_window", &o->angular_search_window, 0, kPi, "rad",
       "Poses turned so far from the guess are tried."},
      {"translation_delta_cost_weight", &o->translation_delta_cost_weight, 0, kMaxWeight, "1/m",
       "How much leaving the guess costs."},
      {"rotation_delta_cost_weight", &o->rotation_delta_cost_weight, 0, kMaxWeight, "1/rad",
       "How much turning away from the guess costs."},
  };
}

Rows CeresScanMatcherRows(CeresScanMatcherOptions* o) {
  return {
      {"occupied_space_weight", &o->occupied_space_weight, 0, kMaxWeight, "",
       "How much points in cells that are not occupied cost."},
      {"translation_weight", &o->translation_weight, 0, kMaxWeight, "1/m",
       "How much leaving the predicted place costs."},
      {"rotation_weight", &o->rotation_weight, 0, kMaxWeight, "1/rad",
       "How much turning away from where it starts costs."},
      {"ceres_solver_options.max_num_iterations", &o->max_num_iterations, 0, kMaxCount, "",
       "The solver stops after so many iterations."},
  };
}

Rows RecoveryRows(RecoveryOptions* o) {
  return {
      {"min_relative_score", &o->min_relative_score, 0, 1, "",
       "A scan that scores less than this share of the average is searched for widely; 0: never."},
      {"unmeasured_min_relative_score", &o->unmeasured_min_relative_score, 0, 1, "",
       "The same share where no odometry predicted the scan; any gain is taken then."},
      {"unmeasured_linear_search_window", &o->unmeasured_linear_search_window, 0, 10, "m",
       "Where a scan that no odometry predicted is looked for first."},
      {"unmeasured_angular_search_window", &o->unmeasured_angular_search_window, 0, kPi, "rad",
       "How far a scan that no odometry predicted is turned first, to either side."},
      {"unmeasured_min_score_ratio", &o->unmeasured_min_score_ratio, 0, 10, "",
       "What lies beyond must score this many times as much as all that lies there."},
      {"min_gain", &o->min_gain, 0, 1, "",
       "What was found is taken if its mean probability is higher by this much."},
      {"linear_search_window", &o->linear_search_window, 0, 10, "m",
       "Poses so far from the guess in x and y are tried."},
      {"angular_search_window", &o->angular_search_window, 0, kPi, "rad",
       "Poses turned so far from the guess are tried."},
      {"max_num_scans_ahead", &o->max_num_scans_ahead, 0, 1000, "",
       "A scan that matches nowhere has its share of the jump to the next one that does, among so "
       "many; 0: it stays where odometry has it."},
  };
}

Rows MotionFilterRows(MotionFilterOptions* o) {
  return {
      {"max_time_seconds", &o->max_time_seconds, 0, 1e6, "s",
       "A scan later than that after the last node becomes a node."},
      {"max_distance_meters", &o->max_distance_meters, 0, kMaxLength, "m",
       "A scan farther than that from the last node becomes a node."},
      {"max_angle_radians", &o->max_angle_radians, 0, kPi, "rad",
       "A scan turned by more than that since the last node becomes a node."},
  };
}

Rows SubmapsRows(SubmapsOptions* o) {
  ScanInserterOptions& inserter = o->range_data_inserter;
  const std::string grid_inserter = "range_data_inserter.probability_grid_range_data_inserter.";
  return {
      {"num_range_data", &o->num_range_data, 1, kMaxCount, "",
       "A new submap begins after so many nodes, and is finished after twice as many."},
      {"grid_options_2d.resolution", &o->grid_resolution, 0.005, 1, "m", "Edge of a cell."},
      {grid_inserter + "insert_free_space", &inserter.insert_free_space, 0, 0, "",
       "Whether misses are written."},
      {grid_inserter + "hit_probability", &inserter.hit_probability, 0.501, 0.9, "",
       "What a hit says about its cell."},
      {grid_inserter + "miss_probability", &inserter.miss_probability, 0.1, 0.499, "",
       "What a miss says about its cell."},
      {grid_inserter + "max_wall_gap", &inserter.max_wall_gap, 0, kMaxLength, "m",
       "Between neighbouring returns of one straight wall, up to which cells between them are "
       "hits, "
       "too; 0: never. Not in Cartographer."},
  };
}

Rows LocalSlamRows(LocalSlamOptions* o) {
  Rows rows = RangeRows(&o->range);
  rows.push_back({"voxel_filter_size", &o->voxel_filter_size, 0.001, 10, "m",
                  "Edge of the voxels that keep one point of the scan each."});
  Append("adaptive_voxel_filter.", AdaptiveVoxelFilterRows(&o->adaptive_voxel_filter), &rows);
  Append("loop_closure_adaptive_voxel_filter.",
         AdaptiveVoxelFilterRows(&o->loop_closure_adaptive_voxel_filter), &rows);
  rows.push_back({"min_num_matched_points", &o->min_num_matched_points, 0, kMaxCount, "",
                  "A scan with fewer points stays where it is predicted."});
  rows.push_back({"odometry_calibration_memory", &o->odometry_calibration_memory, 0, 1e6, "m",
                  "Way over which it is learned how far odometry moves, and to which side of the "
                  "scanner; 0: not."});
  rows.push_back({"steady_pace_memory", &o->steady_pace_memory, 0, kMaxCount, "",
                  "Scans over which it is learned whether stamps tell how far a robot without "
                  "odometry went; 0: they do."});
  rows.push_back({"unmeasured_prior_scale", &o->unmeasured_prior_scale, 1, 100, "",
                  "Without odometry, the windows of local matching are larger, and its weights on "
                  "leaving the prediction smaller, by this factor."});
  rows.push_back({"full_prior_motion", &o->full_prior_motion, 0, 1000, "m",
                  "A scan before which odometry measured less is held where that predicts it by a "
                  "larger weight, in inverse proportion, up to 2.5 times; 0: by the same."});
  rows.push_back({"max_correction_between_nodes", &o->max_correction_between_nodes, 0, 1000, "m",
                  "Odometry predicts a scan from the last one that was inserted, until a match "
                  "corrects it by more; 0: from the scan before."});
  rows.push_back(
      {"velocity_gain", &o->velocity_gain, 0.01, 1, "",
       "Without odometry, share of the last motion in the velocity that predicts the next "
       "one. Not in Cartographer."});
  rows.push_back(
      {"second_prior_relative_score", &o->second_prior_relative_score, 0, 1, "",
       "A scan that matches less than this share of the average where odometry puts it is "
       "also matched where the velocity does; 0: never. Not in Cartographer."});
  rows.push_back(
      {"max_changed_share_at_standstill", &o->max_changed_share_at_standstill, 0, 1, "",
       "Odometry that measured no motion hangs, and is not used, if more than this share "
       "of what the scanner sees changed; 1: it never does. Not in Cartographer."});
  rows.push_back(
      {"standstill_min_score_ratio", &o->standstill_min_score_ratio, 0, 10, "",
       "Where odometry stands still, a scan is believed where it matches without odometry "
       "if it scores this many times as much there; 0: never. Not in Cartographer."});
  rows.push_back(
      {"unusual_motion_min_score_ratio", &o->unusual_motion_min_score_ratio, 0, 10, "",
       "Where odometry measured a motion that is hardly ever measured or made, or the scan matches "
       "nowhere, it is believed where it matches without odometry if it and the three ahead score "
       "this many times as much there; 0: never. Not in Cartographer."});
  rows.push_back(
      {"past_motions_weight", &o->past_motions_weight, 0, 1, "",
       "Without odometry, where scans are sparse, the power to which the likelihood of a "
       "motion, judged by those before, counts; 0: not. Not in Cartographer."});
  rows.push_back(
      {"share_beside_walls", &o->share_beside_walls, 0, 1, "",
       "Scans that are far apart, or without odometry, are matched as if walls were a cell wider "
       "to all sides, where they count for this share; 0: as they are. Not in Cartographer."});
  rows.push_back({"use_online_correlative_scan_matching", &o->use_online_correlative_scan_matching,
                  0, 0, "", "Whether the correlative matcher runs before (CS)."});
  Append("real_time_correlative_scan_matcher.",
         CorrelativeScanMatcherRows(&o->real_time_correlative_scan_matcher), &rows);
  Append("ceres_scan_matcher.", CeresScanMatcherRows(&o->ceres_scan_matcher), &rows);
  Append("recovery.", RecoveryRows(&o->recovery), &rows);
  Append("motion_filter.", MotionFilterRows(&o->motion_filter), &rows);
  Append("submaps.", SubmapsRows(&o->submaps), &rows);
  return rows;
}

Rows FastCorrelativeScanMatcherRows(BranchAndBoundOptions* o) {
  return {
      {"linear_search_window", &o->linear_search_window, 0, kMaxWindow, "m",
       "W_x and W_y of eq. 8: how far from the guess a loop is searched."},
      {"angular_search_window", &o->angular_search_window, 0, kPi, "rad",
       "W_theta of eq. 8: how far a loop may be turned from the guess."},
      {"branch_and_bound_depth", &o->branch_and_bound_depth, 1, 12, "",
       "Number of precomputed grids, h_0 + 1 of eq. 13; more than 5 change nothing, since higher "
       "nodes hardly ever tell places apart."},
  };
}

Rows LoopAmbiguityRows(LoopAmbiguityOptions* o) {
  return {
      {"max_relative_score", &o->max_relative_score, 0, 1, "",
       "Share of the winner's score that no place far from it may have; 1: off."},
      {"min_distance", &o->min_distance, 0, kMaxLength, "m",
       "From the winner, at which a place is another one."},
      {"refuse_at_border", &o->refuse_at_border, 0, 0, "",
       "Refuse winners at the border of the search window, beyond which may be better ones."},
  };
}

Rows LoopConsistencyRows(LoopConsistencyOptions* o) {
  return {
      {"min_num_supporters", &o->min_num_supporters, 0, kMaxCount, "",
       "A loop needs loops of so many other nodes that agree with it; 0: none."},
      {"good_score_ratio", &o->good_score_ratio, 0, 10, "",
       "One fewer is enough for a loop that scores so many times as much as it must; 0: for none."},
      {"max_way", &o->max_way, 0, 1e6, "m",
       "Loops are compared over ways of local SLAM no longer than this."},
      {"max_distance", &o->max_distance, 0, kMaxLength, "m", "Loops that agree differ by no more."},
      {"max_distance_per_meter", &o->max_distance_per_meter, 0, 1, "m/m",
       "On top of it, for each metre of way between them."},
      {"min_way", &o->min_way, 0, 1e6, "m",
       "Loops of nodes nearer to each other, along the way, count as one."},
      {"num_checked_neighbors", &o->num_checked_neighbors, 0, kMaxCount, "",
       "Neighbours of a loop without support that are searched where it has them; 0: none."},
      {"max_angle", &o->max_angle, 0, kPi, "rad", "Loops that agree are turned by no more."},
  };
}

Rows SecondLookRows(SecondLookOptions* o) {
  return {
      {"num_nodes", &o->num_nodes, 0, kMaxCount, "",
       "Of a submap without a loop to another of the same place so many nodes are searched; 0: "
       "none."},
      {"max_distance", &o->max_distance, 0, kMaxLength, "m",
       "A second look is for nodes so near to the box around the submap's nodes."},
      {"max_unseen_distance", &o->max_unseen_distance, 0, kMaxLength, "m",
       "A second look is for nodes so near to what the submap has seen as free; 0: for all."},
      {"min_way", &o->min_way, 0, 1e6, "m",
       "A second look is for nodes so far from the submap by the way that the robot went."},
      {"min_distance", &o->min_distance, 0, kMaxLength, "m",
       "A second look is for pairs that optimizations moved by so much since the one before."},
  };
}

Rows LastLookRows(LastLookOptions* o) {
  return {
      {"num_nodes", &o->num_nodes, 0, kMaxCount, "",
       "So many nodes of a pair of submaps that no loop ties are searched in the least window, "
       "after the final optimization; 0: none."},
      {"min_score_factor", &o->min_score_factor, 0, 1, "",
       "A last look needs this share of the score that is needed otherwise."},
      {"min_known_share", &o->min_known_share, 0, 1, "",
       "A last look counts the points in what the submap knows, at least this share of all; 1: "
       "all."},
  };
}

Rows ConstraintBuilderRows(ConstraintBuilderOptions* o) {
  Rows rows = {
      {"sampling_ratio", &o->sampling_ratio, 0, 1, "",
       "Share of the pairs of node and submap near each other that are searched."},
      {"max_constraint_distance", &o->max_constraint_distance, 0, 1e6, "m",
       "Pairs of node and submap farther apart are not searched."},
      {"min_score", &o->min_score, 0, 1, "",
       "Mean probability that a match needs to become a constraint."},
      {"min_relative_score", &o->min_relative_score, 0, 1, "",
       "Share of what the submap's own nodes score that a match needs to become a constraint; 0: "
       "off. Not in Cartographer."},
      {"linear_search_window_per_meter", &o->linear_search_window_per_meter, 0, 1, "m/m",
       "Growth of the search window with the way gone since the submap. Not in Cartographer."},
      {"angular_search_window_per_meter", &o->angular_search_window_per_meter, 0, 1, "rad/m",
       "Growth of the window's angle with the way gone since the submap. Not in Cartographer."},
      {"max_linear_search_window", &o->max_linear_search_window, 0, kMaxWindow, "m",
       "Where the growth of the search window ends. Not in Cartographer."},
      {"search_window_growth_per_gap", &o->search_window_growth_per_gap, 0, 100, "1/m",
       "Share by which a metre of way counts more for each metre, up to one, between nodes."},
      {"unmatched_node_way", &o->unmatched_node_way, 0, kMaxLength, "m",
       "Metres of way for which a node counts whose scan matched nowhere. Not in Cartographer."},
      {"full_sampling_search_window", &o->full_sampling_search_window, 0, kMaxLength, "m",
       "Pairs with a wider search window are sampled less, in inverse proportion; 0: all alike."},
      {"full_sampling_gap", &o->full_sampling_gap, 0, kMaxLength, "m",
       "Nodes nearer to the one before are sampled less, in proportion; 0: all alike."},
      {"global_localization_min_score", &o->global_localization_min_score, 0, 1, "",
       "Mean probability that a match needs when a whole submap is searched."},
      {"loop_closure_translation_weight", &o->loop_closure_translation_weight, 0, kMaxWeight, "1/m",
       "How stiff a loop closure is in position."},
      {"loop_closure_rotation_weight", &o->loop_closure_rotation_weight, 0, kMaxWeight, "1/rad",
       "How stiff a loop closure is in heading."},
  };
  Append(
      "measured_drift.",
      {{"min_window_share", &o->measured_drift.min_window_share, 0.01, 1, "",
        "To what share search windows may shrink if loops found before took less; 1: off. Not in "
        "Cartographer."}},
      &rows);
  Append("ambiguity.", LoopAmbiguityRows(&o->ambiguity), &rows);
  Append(
      "wall_sides.",
      {{"max_share_from_behind", &o->wall_sides.max_share_from_behind, 0, 1, "",
        "Returns of a loop that may lie on walls that its submap knows from the other side only; "
        "1: all."}},
      &rows);
  Append("consistency.", LoopConsistencyRows(&o->consistency), &rows);
  Append("second_look.", SecondLookRows(&o->second_look), &rows);
  Append("last_look.", LastLookRows(&o->last_look), &rows);
  Append("fast_correlative_scan_matcher.",
         FastCorrelativeScanMatcherRows(&o->fast_correlative_scan_matcher), &rows);
  Append("ceres_scan_matcher.", CeresScanMatcherRows(&o->ceres_scan_matcher), &rows);
  return rows;
}

Rows OptimizationProblemRows(OptimizationProblemOptions* o) {
  return {
      {"huber_scale", &o->huber_scale, 1e-6, kMaxWeight, "",
       "Weighted residual from which a loop closure pulls no harder (rho of eq. 4)."},
      {"local_slam_pose_translation_weight", &o->local_slam_pose_translation_weight, 0, kMaxWeight,
       "1/m", "How stiff local SLAM is between consecutive nodes in position."},
      {"local_slam_pose_rotation_weight", &o->local_slam_pose_rotation_weight, 0, kMaxWeight,
       "1/rad", "How stiff local SLAM is between consecutive nodes in heading."},
      {"odometry_translation_weight", &o->odometry_translation_weight, 0, kMaxWeight, "1/m",
       "How stiff odometry is between consecutive nodes in position."},
      {"odometry_rotation_weight", &o->odometry_rotation_weight, 0, kMaxWeight, "1/rad",
       "How stiff odometry is between consecutive nodes in heading."},
      {"ceres_solver_options.max_num_iterations", &o->max_num_iterations, 0, kMaxCount, "",
       "An optimization on the way stops after so many iterations."},
      {"ceres_solver_options.function_tolerance", &o->function_tolerance, 0, 1, "",
       "An optimization on the way stops when an iteration gains no more than this share of the "
       "cost; the final one at 1e-6."},
      {"outliers.max_distance", &o->outliers.max_distance, 0, kMaxLength, "m",
       "Loops with a larger residual are left out; 0: none."},
      {"outliers.max_angle", &o->outliers.max_angle, 0, kPi, "rad",
       "Loops with a larger residual in heading are left out; 0: none."},
      {"outliers.max_num_rounds", &o->outliers.max_num_rounds, 0, kMaxCount, "",
       "How often an optimization on the way leaves out loops and solves again."},
  };
}

Rows PoseGraphRows(PoseGraphOptions* o) {
  Rows rows = {
      {"optimize_every_n_nodes", &o->optimize_every_n_nodes, 0, kMaxCount, "",
       "Poses are optimized after so many new nodes; 0: only at the end, and no loops."},
      {"optimize_every_share", &o->optimize_every_share, 0, 1, "",
       "Poses are not optimized before the new nodes are this share of all, so that the work for "
       "a node does not grow with the map."},
      {"optimize_at_latest_after_n_nodes", &o->optimize_at_latest_after_n_nodes, 1, kMaxCount, "",
       "Poses are optimized after so many new nodes where optimize_every_share would wait longer."},
      {"min_num_held_nodes", &o->min_num_held_nodes, 0, kMaxCount, "",
       "What is older than the new nodes and all that these have loops with stays where it "
       "is until all loops are judged anew, if it is so many nodes; 0: it moves."}};
  Append("constraint_builder.", ConstraintBuilderRows(&o->constraint_builder), &rows);
  Append("",
         {{"matcher_translation_weight", &o->matcher_translation_weight, 0, kMaxWeight, "1/m",
           "How stiff the place of a node in its own submaps is in position."},
          {"matcher_rotation_weight", &o->matcher_rotation_weight, 0, kMaxWeight, "1/rad",
           "How stiff the place of a node in its own submaps is in heading."}},
         &rows);
  Append("optimization_problem.", OptimizationProblemRows(&o->optimization_problem), &rows);
  rows.push_back({"max_num_final_iterations", &o->max_num_final_iterations, 0, kMaxCount, "",
                  "The final optimization stops after so many iterations."});
  return rows;
}

}  // namespace

std::vector<OptionRow> OptionTable(Options* options) {
  Rows table = {{"use_odometry", &options->trajectory_builder_2d.use_odometry, 0, 0, "",
                 "Whether odometry, where there is any, predicts the motion."}};
  Append("TRAJECTORY_BUILDER_2D.", LocalSlamRows(&options->trajectory_builder_2d), &table);
  Append("POSE_GRAPH.", PoseGraphRows(&options->pose_graph), &table);
  return table;
}

}  // namespace loopscope
