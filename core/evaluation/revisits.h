// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/evaluation/loop_closures.h"

namespace loopscope {

/// When the robot is said to have come back to where another submap was made.
struct RevisitOptions {
  double max_distance = 3.0;  ///< [m] between a node of one submap and a node of the other
  double min_way = 20.0;      ///< [m] that the robot went between the two nodes
  /// Share of the returns of one of the two nodes that have a return of the other's submap nearby,
  /// seen from the same side: rooms on both sides of a wall have nothing in common.
  double min_overlap = 0.5;
};

/// Two submaps of the same place, at least one of them finished.
struct Revisit {
  SubmapId first;
  SubmapId second;    ///< later than first
  NodeId first_node;  ///< the two nodes that are nearest, neither in the other's submap
  NodeId second_node;
  double distance = 0.0;  ///< [m] between them in the reference
};

/// All pairs of submaps of the same place as the reference has it, in order of (first, second).
/// Ways are those of local SLAM.
std::vector<Revisit> RevisitsOf(const Recording& recording, const ReferencePoses& reference,
                                const RevisitOptions& options = {});

/// Those without any of `loops` from one submap to a node of the other.
std::vector<Revisit> RevisitsWithout(const Recording& recording,
                                     const std::vector<JudgedLoop>& loops,
                                     const std::vector<Revisit>& revisits);

}  // namespace loopscope
