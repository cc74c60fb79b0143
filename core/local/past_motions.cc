// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/past_motions.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

constexpr std::size_t kLeastNumMotions = 20;
constexpr std::size_t kMostNumMotions = 300;

constexpr double kLongWay = 0.3;   // [m]
constexpr double kLongTurn = 0.1;  // [rad]

// Motions that differ by three times what MotionPrior blurs them are not alike.
constexpr double kLikeShareOfWay = 0.75;
constexpr double kLikeTurn = DegreesToRadians(18.0);

/// Ahead in the direction between the first heading and the last.
std::vector<Pose2> MotionsOfAnyRobot() {
  std::vector<Pose2> motions;
  for (double degrees = -60.0; degrees <= 60.0; degrees += 10.0) {
    const double turn = DegreesToRadians(degrees);
    for (double way = 0.0; way <= 2.0; way += 0.25) {
      motions.emplace_back(way * std::cos(0.5 * turn), way * std::sin(0.5 * turn), turn);
    }
  }
  return motions;
}

}  // namespace

void PastMotions::Learn(const Pose2& motion) {
  if (motions_.size() < kMostNumMotions) {
    motions_.push_back(motion);
  } else {
    motions_[num_motions_ % kMostNumMotions] = motion;
  }
  ++num_motions_;
}

bool PastMotions::AreFew() const { return motions_.size() < kLeastNumMotions; }

bool PastMotions::SayMoreThanVelocity() const {
  return !AreFew() && (UsualWay(motions_) >= kLongWay || UsualTurn(motions_) >= kLongTurn);
}

MotionPrior PastMotions::Prior(double exponent) const {
  if (!AreFew()) return MotionPrior(motions_, exponent);
  std::vector<Pose2> motions = MotionsOfAnyRobot();
  motions.insert(motions.end(), motions_.begin(), motions_.end());
  return MotionPrior(motions, exponent);
}

bool PastMotions::HaveOneLike(const Pose2& motion) const {
  if (motions_.empty()) return false;
  const double max_way = kLikeShareOfWay * std::max(kLongWay, UsualWay(motions_));
  return std::any_of(motions_.begin(), motions_.end(), [&](const Pose2& other) {
    const double turn = NormalizeAngle(other.rotation - motion.rotation) / kLikeTurn;
    return (other.translation - motion.translation).squaredNorm() / (max_way * max_way) +
               turn * turn <
           1.0;
  });
}

}  // namespace loopscope
