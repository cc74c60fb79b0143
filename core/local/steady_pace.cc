// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/steady_pace.h"

namespace loopscope {
namespace {

/// [m^2] A radian counts as a metre.
double SquaredError(const Pose2& motion_before, double stretch, const Pose2& motion) {
  const double rotation = NormalizeAngle(motion.rotation - stretch * motion_before.rotation);
  return (motion.translation - stretch * motion_before.translation).squaredNorm() +
         rotation * rotation;
}

}  // namespace

double SteadyPace::Stretch(double stretch) const {
  return error_by_scans_ < error_by_stamps_ ? 1.0 : stretch;
}

void SteadyPace::Learn(const Pose2& motion_before, double stretch, const Pose2& motion) {
  if (memory_ == 0) return;
  const double keep = 1.0 - 1.0 / memory_;
  error_by_stamps_ = keep * error_by_stamps_ + SquaredError(motion_before, stretch, motion);
  error_by_scans_ = keep * error_by_scans_ + SquaredError(motion_before, 1.0, motion);
}

}  // namespace loopscope
