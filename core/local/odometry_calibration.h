// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "core/geometry/pose2.h"

namespace loopscope {

/// Where the robot goes when odometry says that it goes a metre ahead. Wheels are never as large as
/// they are taken to be, and the scanner is never mounted quite straight: some per cent of a way
/// too much fold a corridor, and half a degree shifts each predicted pose by a centimetre a metre,
/// always to the same side, to which scans that match along a corridor yield by turning. Learned
/// from how scans were matched; after Roy and Thrun, "Online Self-Calibration for Mobile Robots",
/// ICRA 1999.
class OdometryCalibration {
 public:
  /// `memory` [m] is the way over which what was learned is forgotten; 0: nothing is learned.
  explicit OdometryCalibration(double memory) : memory_(memory) {}

  /// The motion of the scanner that odometry measured as `odometry_motion`.
  Pose2 Corrected(const Pose2& odometry_motion) const;

  /// Between two scans odometry measured one motion, and the scans were matched at another.
  /// `way_is_held` if the match tells how far ahead the robot came, which along the smooth walls of
  /// a corridor it does not.
  void Learn(const Pose2& odometry_motion, const Pose2& matched_motion, bool way_is_held);

  /// [m] Ahead and to the left, for a metre ahead by odometry.
  Eigen::Vector2d MotionPerMeter() const;

 private:
  /// Sums over the motions, which forget.
  struct Sums {
    double squared_way = 0.0;      ///< [m^2] of the way ahead by odometry
    double way_times_error = 0.0;  ///< [m^2]
  };
  static void Add(double way, double error, double kept, Sums* sums);

  double memory_;
  Sums ahead_;
  Sums left_;
};

}  // namespace loopscope
