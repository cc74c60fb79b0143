// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/geometry/trajectory.h"

#include <algorithm>
#include <cassert>

namespace loopscope {

Pose2 PoseAt(const Trajectory& trajectory, double time) {
  assert(!trajectory.empty());
  const auto after =
      std::lower_bound(trajectory.begin(), trajectory.end(), time,
                       [](const TimedPose& pose, double t) { return pose.time < t; });
  if (after == trajectory.begin()) return trajectory.front().map_from_base;
  if (after == trajectory.end()) return trajectory.back().map_from_base;
  if (after->time == time) return after->map_from_base;
  const TimedPose& before = *std::prev(after);
  return Interpolate(before.map_from_base, after->map_from_base,
                     (time - before.time) / (after->time - before.time));
}

}  // namespace loopscope
