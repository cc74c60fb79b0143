// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/slam/recording.h"

namespace loopscope {

/// What was known after a step: how much of the recording had come about, and the poses as the last
/// optimization until then left them, with what came later attached by local SLAM.
struct MapState {
  int step = 0;
  int num_nodes = 0;       ///< recording.nodes()[0 ... num_nodes - 1] existed
  int num_submaps = 0;     ///< likewise
  int num_candidates = 0;  ///< likewise: these had been applied
  int num_optimizations = 0;
  Pose2 global_from_local;  ///< for what is newer than the last optimization
  Pose2 global_from_base;   ///< the robot at the scan of the step
  std::vector<Pose2> global_from_submap;
  std::vector<Pose2> global_from_node;
};

/// How many candidates had been applied after scan `step`.
int NumCandidatesAfterStep(const Recording& recording, int step);

/// The state after scan `step`, in [0, recording.num_steps()). After the last step of a finished
/// run it includes the final optimization.
MapState StateAfterStep(const Recording& recording, int step);

/// What the pairs that came up at scan `step` were judged by: the state after it, but without the
/// optimization that it set off and the loops that entered the graph with that.
MapState StateBeforeOptimization(const Recording& recording, int step);

/// Where the robot was at scan `step` <= state.step, as `state` has it: the pose of the last node
/// until then, carried on by local SLAM.
Pose2 GlobalFromBase(const Recording& recording, const MapState& state, int step);

}  // namespace loopscope
