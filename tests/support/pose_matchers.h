// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <ostream>
#include <string>

#include <gmock/gmock.h>

#include "core/geometry/pose2.h"

namespace loopscope {

/// How GoogleTest shows a pose.
inline void PrintTo(const Pose2& pose, std::ostream* out) {
  *out << "(" << pose.x() << " m, " << pose.y() << " m, " << RadiansToDegrees(pose.rotation)
       << " deg)";
}

/// Matches a pose that is at most `meters` and `radians`, the shorter way round, off `expected`.
MATCHER_P3(PoseNear, expected, meters, radians,
           std::string(negation ? "is not" : "is") + " within " + testing::PrintToString(meters) +
               " m and " + testing::PrintToString(RadiansToDegrees(radians)) + " deg of " +
               testing::PrintToString(expected)) {
  const double distance = (arg.translation - expected.translation).norm();
  const double turn = std::abs(NormalizeAngle(arg.rotation - expected.rotation));
  *result_listener << "which is " << distance << " m and " << RadiansToDegrees(turn) << " deg off";
  return distance <= meters && turn <= radians;
}

}  // namespace loopscope
