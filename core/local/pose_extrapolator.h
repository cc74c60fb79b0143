// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry/pose2.h"
#include "core/local/odometry_calibration.h"
#include "core/local/past_motions.h"
#include "core/local/steady_pace.h"
#include "core/local/usual_motion.h"

namespace loopscope {

/// What is known of the motion from one scan to the next after matching.
struct MotionKnowledge {
  /// The match agrees with odometry, or the scan fits less 0.1 m ahead and back.
  bool is_known = false;
  /// It does both, and so tells how far odometry moves, see OdometryCalibration.
  bool way_is_held = false;
  /// The scan was not inserted, and its match hardly corrected odometry, which goes on from where
  /// it began and not from here.
  bool odometry_goes_on = false;
};

/// Predicts where the robot is when a scan comes, from where the scans before were matched.
class PoseExtrapolator {
 public:
  /// `velocity_gain` in (0, 1] is how much of the velocity is that of the last motion; what is left
  /// is that before it.
  PoseExtrapolator(const OdometryCalibration& calibration, const SteadyPace& pace,
                   double velocity_gain)
      : calibration_(calibration), pace_(pace), velocity_gain_(velocity_gain) {}

  /// The pose at `time` [s]: the motion that odometry measured since the last pose from which it
  /// did not just go on, if it was known at the last pose and is now; else as PredictByVelocity has
  /// it. The identity before any pose is known.
  Pose2 Predict(double time, const std::optional<Pose2>& odom_from_base) const;

  /// Whatever odometry says: the robot goes on at its velocity, and turns as it did between the
  /// last two poses, both kept up as SteadyPace has it. The last pose while there is no other.
  Pose2 PredictByVelocity(double time) const;

  /// The identity before any pose is known.
  Pose2 LastPose() const { return last_ ? last_->local_from_base : Pose2(); }

  /// Whether odometry, which now has the robot at `odom_from_base`, measured the motion since the
  /// last pose: it was known there, too.
  bool MotionIsMeasured(const std::optional<Pose2>& odom_from_base) const {
    return odom_from_base && last_ && last_->odom_from_base;
  }

  /// Whether odometry measured no motion at all since the last pose: the robot rests, or odometry
  /// hangs.
  bool StandsStill(const Pose2& odom_from_base) const {
    return last_ && last_->odom_from_base == odom_from_base;
  }

  /// Whether odometry measured a motion since the last pose that it hardly ever measures, or, in
  /// sparse logs, one that the robot never made.
  bool IsUnusual(const Pose2& odom_from_base) const;

  /// All that were known.
  const PastMotions& past_motions() const { return past_motions_; }

  /// Tells where the scan at `time` was matched, and what that tells.
  void AddPose(double time, const Pose2& local_from_base,
               const std::optional<Pose2>& odom_from_base, const MotionKnowledge& knowledge);

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
  std::optional<Known> start_of_odometry_;  ///< from where it predicts
  std::optional<Known> before_last_;
  OdometryCalibration calibration_;
  UsualMotion usual_motion_;
  PastMotions past_motions_;
  SteadyPace pace_;
  double velocity_gain_;
  Eigen::Vector2d velocity_ =
      Eigen::Vector2d::Zero();  ///< [m] for a scan, in the frame of the base
};

}  // namespace loopscope
