// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry/pose2.h"
#include "core/local/odometry_direction.h"
#include "core/local/steady_pace.h"

namespace loopscope {

/// Predicts where the robot is when a scan comes, from where the scans before were matched.
class PoseExtrapolator {
 public:
  PoseExtrapolator(const OdometryDirection& direction, const SteadyPace& pace)
      : direction_(direction), pace_(pace) {}

  /// The pose at `time` [s]: the motion that odometry measured since the last pose, if it was known
  /// there and is now; else the motion between the last two poses, kept up as SteadyPace has it.
  /// The identity before any pose is known.
  Pose2 Predict(double time, const std::optional<Pose2>& odom_from_base) const;

  /// Tells where the scan at `time` was matched.
  void AddPose(double time, const Pose2& local_from_base,
               const std::optional<Pose2>& odom_from_base);

 private:
  struct Known {
    double time = 0.0;
    Pose2 local_from_base;
    std::optional<Pose2> odom_from_base;
  };
  /// The time from the last pose to `time`, in times of that between the last two.
  double StretchUntil(double time) const;
  /// Between the last two poses.
  Pose2 LastMotion() const;

  std::optional<Known> last_;
  std::optional<Known> before_last_;
  OdometryDirection direction_;
  SteadyPace pace_;
};

}  // namespace loopscope
