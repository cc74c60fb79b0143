// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// [m] By how much `motion`, in the frame of the robot, leads beside where wheels take it: these
/// take it ahead or back in a direction between its first heading and its last.
double SidewaysMotionOf(const Pose2& motion);

/// Tells what odometry measures from one scan to the next all the time from what it measures when
/// it jumps. What is usual is learned, for some robots do move sideways, and some logs have a scan
/// only now and then.
class UsualMotion {
 public:
  /// Whether `motion` leads sideways by 0.2 m or turns by 20 deg, and by four times what those
  /// before did (root mean square).
  bool IsExceededBy(const Pose2& motion) const;

  void Learn(const Pose2& motion);

 private:
  double sum_of_squared_sideways_ = 0.0;  ///< [m^2]
  double sum_of_squared_turns_ = 0.0;     ///< [rad^2]
  int num_motions_ = 0;
};

}  // namespace loopscope
