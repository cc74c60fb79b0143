// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/graph/last_look.h"
#include "core/graph/loop_consistency.h"
#include "core/graph/second_look.h"
#include "core/graph/wall_sides.h"
#include "core/matching/branch_and_bound.h"
#include "core/matching/scan_match_refinement.h"

namespace loopscope {

/// POSE_GRAPH.constraint_builder.ambiguity, not in Cartographer: a scan that fits at many places of
/// a corridor does not tell where it is.
struct LoopAmbiguityOptions {
  double max_relative_score = 1.0;  ///< share of the winner's score that no rival may have; 1: off
  double min_distance = 0.5;        ///< [m] from the winner at which a place is another one
  bool refuse_at_border = false;  ///< winners at the border of the window: one beyond may be better
};

/// POSE_GRAPH.constraint_builder.measured_drift, not in Cartographer: search windows as large as
/// the loops that were found before tell, see PredictDriftShare.
struct MeasuredDriftOptions {
  double min_window_share = 1.0;  ///< of the windows that would be searched otherwise; 1: off
};

/// POSE_GRAPH.constraint_builder.
struct ConstraintBuilderOptions {
  double sampling_ratio = 0.3;  ///< share of the near pairs that are searched
  /// [m] between the node and the box around the nodes of the submap; on top of the search window.
  double max_constraint_distance = 15.0;
  double min_score = 0.55;
  /// A share of the score that the submap's own nodes have in it, which the score must reach too;
  /// not in Cartographer. It fits sparse logs, whose cells are seen too rarely to become certain.
  double min_relative_score = 0.0;
  /// Growth of the linear search window for a metre of the way that the robot went, over known
  /// loops, from the submap to the node [m/m], and of the angular one [rad/m]; not in Cartographer.
  double linear_search_window_per_meter = 0.0;
  double angular_search_window_per_meter = 0.0;
  double max_linear_search_window = 30.0;  ///< [m] where growth ends
  /// [1/m] By how much more a metre of way lets windows grow for each metre, up to one, that lies
  /// between the nodes; not in Cartographer. Scans taken far apart overlap less, and drift more.
  double search_window_growth_per_gap = 0.0;
  /// [m] of the way for which a node counts whose scan matched nowhere; not in Cartographer. Where
  /// local SLAM lost the robot on a turn, what comes after lies farther off than drift explains.
  double unmatched_node_way = 0.0;
  /// [m] Pairs with a wider linear search window are sampled less, in inverse proportion to it; not
  /// in Cartographer. 0: all alike.
  double full_sampling_search_window = 0.0;
  /// [m] Nodes nearer to the one before are sampled less, in proportion to how far they are; not in
  /// Cartographer. 0: all alike.
  double full_sampling_gap = 0.0;
  double global_localization_min_score = 0.6;  ///< when a whole submap is searched
  double loop_closure_translation_weight = 1.1e4;
  double loop_closure_rotation_weight = 1e5;
  MeasuredDriftOptions measured_drift;
  LoopAmbiguityOptions ambiguity;
  WallSidesOptions wall_sides;
  LoopConsistencyOptions consistency;
  SecondLookOptions second_look;
  LastLookOptions last_look;
  BranchAndBoundOptions fast_correlative_scan_matcher;
  CeresScanMatcherOptions ceres_scan_matcher{20.0, 10.0, 1.0, 10};
};

/// POSE_GRAPH.optimization_problem.outliers, not in Cartographer: loops that an optimization leaves
/// with a larger residual of eq. 5 are false, and are left out of it.
struct OutlierOptions {
  double max_distance = 0.0;                 ///< [m]; 0: off
  double max_angle = DegreesToRadians(3.0);  ///< [rad]
  /// How often an optimization on the way leaves out loops and solves again; the next one goes on.
  /// Until nothing changes, it would take the longer the larger the map is.
  int max_num_rounds = 10;
};

/// POSE_GRAPH.optimization_problem. Weights are factors of a residual in metres or radians, so
/// their squares are information.
struct OptimizationProblemOptions {
  double huber_scale = 1e1;  ///< rho of eq. 4, on INTER_SUBMAP constraints
  double local_slam_pose_translation_weight = 1e5;
  double local_slam_pose_rotation_weight = 1e5;
  double odometry_translation_weight = 1e5;
  double odometry_rotation_weight = 1e5;
  int max_num_iterations = 50;
  double function_tolerance = 1e-6;  ///< of SolverLimits, on the way; the final one has 1e-6
  OutlierOptions outliers;
};

/// POSE_GRAPH.
struct PoseGraphOptions {
  int optimize_every_n_nodes = 90;  ///< 0: only at the end, and no loops
  /// Not in Cartographer: nor before this share of all nodes is new. So what optimizations cost a
  /// node does not grow with the map.
  double optimize_every_share = 0.0;
  /// Not in Cartographer: but that share delays none beyond so many new nodes, for what is new
  /// meanwhile is searched in many submaps in wide windows.
  int optimize_at_latest_after_n_nodes = 1'000'000;
  /// Not in Cartographer: an optimization on the way holds the poses of all that is older than what
  /// is new and what that has loops with, if these are so many nodes; 0: never. All move when all
  /// loops are judged anew, and in the end.
  int min_num_held_nodes = 0;
  ConstraintBuilderOptions constraint_builder;
  double matcher_translation_weight = 5e2;  ///< of INTRA_SUBMAP constraints
  double matcher_rotation_weight = 1.6e3;
  OptimizationProblemOptions optimization_problem;
  int max_num_final_iterations = 200;
};

}  // namespace loopscope
