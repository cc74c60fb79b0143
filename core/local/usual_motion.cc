// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/usual_motion.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

constexpr double kLeastSideways = 0.2;  // [m]
constexpr double kLeastTurn = DegreesToRadians(20.0);
constexpr double kNumDeviations = 4.0;

/// [rad] from `angle` to the nearest of those between 0 and `turn`, none farther than pi.
double AngleOutside(double angle, double turn) {
  const auto [least, most] = std::minmax({0.0, turn});
  if (angle >= least && angle <= most) return 0.0;
  return std::min(std::abs(angle), std::abs(NormalizeAngle(angle - turn)));
}

double RootMeanSquare(double sum_of_squares, int count) {
  return count == 0 ? 0.0 : std::sqrt(sum_of_squares / count);
}

}  // namespace

double SidewaysMotionOf(const Pose2& motion) {
  const double turn = NormalizeAngle(motion.rotation);
  const double ahead = std::atan2(motion.y(), motion.x());
  const double back = NormalizeAngle(ahead + M_PI);
  const double outside = std::min(AngleOutside(ahead, turn), AngleOutside(back, turn));
  return motion.translation.norm() * std::sin(outside);
}

bool UsualMotion::IsExceededBy(const Pose2& motion) const {
  const double sideways = RootMeanSquare(sum_of_squared_sideways_, num_motions_);
  const double turn = RootMeanSquare(sum_of_squared_turns_, num_motions_);
  return SidewaysMotionOf(motion) > std::max(kLeastSideways, kNumDeviations * sideways) ||
         std::abs(NormalizeAngle(motion.rotation)) > std::max(kLeastTurn, kNumDeviations * turn);
}

void UsualMotion::Learn(const Pose2& motion) {
  const double sideways = SidewaysMotionOf(motion);
  const double turn = NormalizeAngle(motion.rotation);
  sum_of_squared_sideways_ += sideways * sideways;
  sum_of_squared_turns_ += turn * turn;
  ++num_motions_;
}

}  // namespace loopscope
