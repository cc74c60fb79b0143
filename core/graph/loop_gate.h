// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "core/geometry/id.h"
#include "core/geometry/pose2.h"
#include "core/graph/loop_candidate.h"
#include "core/graph/pose_graph_options.h"
#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"

namespace loopscope {

/// [m] What the `gap` [m] from a node to the next counts on the way over which search windows grow;
/// more if that one `matched_nowhere`, so that nobody knows how the robot came there.
double CountedWay(double gap, bool matched_nowhere, const ConstraintBuilderOptions& options);

/// What decides, before any search, whether a node and a submap may see the same place, and how far
/// off the estimate may be.
struct LoopGate {
  double way = 0.0;  ///< [m] from the submap to the node, over known loops, as CountedWay has it
  double distance = 0.0;        ///< [m] from the node to the box around the nodes of the submap
  double linear_window = 0.0;   ///< [m] in which to search
  double angular_window = 0.0;  ///< [rad]
  bool is_near = false;         ///< distance <= max_constraint_distance + growth of the window
};

/// `node_box` is the box around the submap's own nodes, in its frame [m].
LoopGate EvaluateLoopGate(const Pose2& submap_from_node_guess, const Eigen::AlignedBox2d& node_box,
                          double way, const ConstraintBuilderOptions& options);

/// The pair as it comes up in `step` with `gate` and `min_score`: kTooFar, or else kNotSampled yet.
LoopCandidate AtGate(const LoopGate& gate, SubmapId submap, NodeId node, int step,
                     const Pose2& submap_from_node_guess, double min_score);

/// [m] No gate with these options has a larger one.
double MaxLinearWindow(const ConstraintBuilderOptions& options);

/// [m] No gate with these options is near beyond it.
double MaxGateDistance(const ConstraintBuilderOptions& options);

/// By how much a pair counts when pairs are sampled, in (0, 1]: less if its `linear_window` [m] is
/// wide, for the time that it takes, and less if the node is no farther than `gap` [m] from the one
/// before, for it tells little new. One that only turned counts a quarter.
double SamplingShare(double linear_window, double gap, const ConstraintBuilderOptions& options);

/// A node in a submap.
struct PlacedScan {
  const PointCloud* points_in_node;
  Pose2 submap_from_node;
};

/// The score that a loop into a submap must beat: min_score, or min_relative_score of what the
/// submap's own nodes score in its grid on average, whichever is more.
double MinLoopScore(const std::vector<PlacedScan>& own_nodes, const ProbabilityGrid& grid,
                    const ConstraintBuilderOptions& options);

}  // namespace loopscope
