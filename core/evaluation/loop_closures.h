// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/trajectory.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// reference_from_node of each node; nothing where its scan is outside of the reference's time.
using ReferencePoses = std::vector<std::optional<Pose2>>;

/// Poses of all nodes in a trajectory that is taken as true, interpolated at the stamps of their
/// scans.
ReferencePoses ReferencePosesOfNodes(const Recording& recording, const Trajectory& reference);

/// How far a loop may be off.
struct LoopTolerance {
  double translation = 0.0;  ///< [m]
  double rotation = 0.0;     ///< [rad]
};

/// "Within 20 cm and 1 deg of the optimized solution": Table IV of the paper.
constexpr LoopTolerance kPaperTolerance{0.2, DegreesToRadians(1.0)};

/// For references that a SLAM system made, which are wrong by decimetres and some degrees
/// themselves; a false loop of a corridor is off by more than half a metre.
constexpr LoopTolerance kReferenceTolerance{0.5, DegreesToRadians(5.0)};

/// How one INTER_SUBMAP constraint stands at the end.
struct JudgedLoop {
  SubmapId submap;
  NodeId node;
  Pose2 submap_from_node;    ///< as measured
  Eigen::Vector3d residual;  ///< of eq. 5, in the poses of the state [m, m, rad]
  /// rho'(|r|^2) of Huber's loss at the weighted residual r, in (0, 1]: how hard the loop still
  /// pulls compared with what it would without the loss; 0 if it is an outlier.
  double weight = 1.0;
  /// Left out of the final optimization, see OutlierOptions; where these are off, of a weight of
  /// less than 0.5.
  bool is_outlier = false;
  /// Expected^-1 * measured, of the node seen from that node of the submap which the measurement
  /// puts it nearest to. Nothing if the reference does not cover both.
  std::optional<Pose2> error;

  bool IsInForce() const { return !is_outlier; }
};

bool IsWithin(const Pose2& error, const LoopTolerance& tolerance);

/// Known to be out of `tolerance`.
bool IsWrong(const JudgedLoop& loop, const LoopTolerance& tolerance);

/// All accepted loops of the state, in the order in which they were applied. `reference` holds a
/// pose for every node, or is empty if there is none.
std::vector<JudgedLoop> JudgeLoops(const Recording& recording, const MapState& state,
                                   const ReferencePoses& reference);

/// Counts of loops. A precision is the quotient of two of them.
struct LoopCounts {
  int all = 0;
  int self_consistent = 0;  ///< of all, within kPaperTolerance of the optimized solution
  int in_force = 0;
  int judged = 0;   ///< those in force that the reference covers
  int correct = 0;  ///< those judged that are within tolerance
};

LoopCounts CountLoops(const std::vector<JudgedLoop>& loops, const LoopTolerance& tolerance);

}  // namespace loopscope
