// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/pose2.h"

namespace loopscope {

struct TimedPose {
  double time = 0.0;  ///< [s]
  Pose2 map_from_base;
};

/// Poses of the robot over time, in the order of time.
using Trajectory = std::vector<TimedPose>;

/// The pose at `time`, interpolated between its neighbours; before the first and after the last
/// pose it is theirs. `trajectory` must not be empty.
Pose2 PoseAt(const Trajectory& trajectory, double time);

}  // namespace loopscope
