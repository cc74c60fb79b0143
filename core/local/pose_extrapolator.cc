// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/pose_extrapolator.h"

#include <algorithm>

namespace loopscope {
namespace {

/// A pause in the log says nothing about the velocity after it, so no motion is stretched by more.
constexpr double kMaxStretch = 3.0;

}  // namespace

Pose2 PoseExtrapolator::Predict(double time, const std::optional<Pose2>& odom_from_base) const {
  if (!last_) return Pose2();
  if (MotionIsMeasured(odom_from_base)) {
    return start_of_odometry_->local_from_base *
           calibration_.Corrected(start_of_odometry_->odom_from_base->Inverse() * *odom_from_base);
  }
  return PredictByVelocity(time);
}

Pose2 PoseExtrapolator::PredictByVelocity(double time) const {
  if (!last_) return Pose2();
  if (!before_last_) return last_->local_from_base;
  const double stretch = pace_.Stretch(StretchUntil(time));
  return last_->local_from_base * Pose2(stretch * velocity_, stretch * LastMotion().rotation);
}

bool PoseExtrapolator::IsUnusual(const Pose2& odom_from_base) const {
  if (!MotionIsMeasured(odom_from_base)) return false;
  const Pose2 motion = last_->odom_from_base->Inverse() * odom_from_base;
  return usual_motion_.IsExceededBy(motion) ||
         (past_motions_.SayMoreThanVelocity() && !past_motions_.HaveOneLike(motion));
}

Pose2 PoseExtrapolator::LastMotion() const {
  return before_last_->local_from_base.Inverse() * last_->local_from_base;
}

double PoseExtrapolator::StretchUntil(double time) const {
  if (last_->time <= before_last_->time) return 0.0;
  return std::clamp((time - last_->time) / (last_->time - before_last_->time), 0.0, kMaxStretch);
}

void PoseExtrapolator::AddPose(double time, const Pose2& local_from_base,
                               const std::optional<Pose2>& odom_from_base,
                               const MotionKnowledge& knowledge) {
  const bool goes_on = knowledge.odometry_goes_on && MotionIsMeasured(odom_from_base);
  if (last_) {
    const Pose2 motion = last_->local_from_base.Inverse() * local_from_base;
    if (MotionIsMeasured(odom_from_base)) {
      const Pose2 odometry_motion = last_->odom_from_base->Inverse() * *odom_from_base;
      calibration_.Learn(odometry_motion, motion, knowledge.way_is_held);
      usual_motion_.Learn(odometry_motion);
    }
    if (knowledge.is_known) past_motions_.Learn(motion);
    if (before_last_) pace_.Learn(LastMotion(), StretchUntil(time), motion);
    const double gain = before_last_ ? velocity_gain_ : 1.0;
    velocity_ += gain * (motion.translation - velocity_);
  }
  before_last_ = last_;
  last_ = Known{time, local_from_base, odom_from_base};
  if (!goes_on) start_of_odometry_ = last_;
}

}  // namespace loopscope
