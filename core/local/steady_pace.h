// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// How far a robot without odometry goes until the next scan, if it goes on as it did: as far as
/// the stamps say, or, where these jitter as in logs that were written in bursts, as far as from
/// each scan to the next. Which of the two predicts better is learned from how scans were matched.
class SteadyPace {
 public:
  /// `memory` is the number of scans over which what was learned is forgotten; 0: stamps hold.
  explicit SteadyPace(int memory) : memory_(memory) {}

  /// How many times the motion before comes now. `stretch` is what the stamps say.
  double Stretch(double stretch) const;

  /// Between two scans the robot made one motion, and another one until the scan after them.
  void Learn(const Pose2& motion_before, double stretch, const Pose2& motion);

 private:
  int memory_;
  double error_by_stamps_ = 0.0;  // decaying sum of squares [m^2]
  double error_by_scans_ = 0.0;   // likewise
};

}  // namespace loopscope
