// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/trajectory.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

// The way of the robot in the map frame, in the order of the stamps. (That of the log is another
// one where stamps run backwards.)

/// The optimized poses of the nodes, at the stamps of their scans.
Trajectory NodeTrajectory(const Recording& recording, const MapState& state);

/// A pose for every stamp of scans and odometry up to state.step; after the last scan of the log
/// also for the odometry behind it. Nodes are carried on by local SLAM to the scans between them,
/// and those by raw odometry; what is missing to the next node or scan is spread over those on the
/// way. Where the odometry jumped, the way between is taken as straight. Without odometry (or with
/// use_odometry off), there are poses for scans only.
Trajectory DenseTrajectory(const Recording& recording, const MapState& state);

}  // namespace loopscope
