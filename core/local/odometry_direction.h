// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// To which side of the scanner's axis the robot moves when odometry says that it moves ahead: the
/// scanner is never mounted quite straight. Half a degree shifts each predicted pose by a
/// centimetre a metre, always to the same side, and scans that match along a corridor yield to it
/// by turning. Learned from how scans were matched; after Roy and Thrun, "Online Self-Calibration
/// for Mobile Robots", ICRA 1999.
class OdometryDirection {
 public:
  /// `memory` [m] is the way over which what was learned is forgotten; 0: nothing is learned.
  explicit OdometryDirection(double memory) : memory_(memory) {}

  /// The motion of the scanner's axis that odometry measured as `odometry_motion`.
  Pose2 Corrected(const Pose2& odometry_motion) const;

  /// Between two scans odometry measured one motion, and the scans were matched at another.
  void Learn(const Pose2& odometry_motion, const Pose2& matched_motion);

  double angle() const;  ///< [rad] to the left

 private:
  double memory_;
  double squared_way_ = 0.0;  ///< [m^2] sum over the motions, of the way ahead
  double drift_left_ = 0.0;   ///< [m^2] likewise, of the way ahead times the error to the left
};

}  // namespace loopscope
