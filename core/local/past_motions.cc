// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/past_motions.h"

#include <algorithm>

namespace loopscope {
namespace {

constexpr std::size_t kLeastNumMotions = 20;
constexpr std::size_t kMostNumMotions = 300;

constexpr double kLongWay = 0.3;   // [m]
constexpr double kLongTurn = 0.1;  // [rad]

// Motions that differ by three times what MotionPrior blurs them are not alike.
constexpr double kLikeShareOfWay = 0.75;
constexpr double kLikeTurn = DegreesToRadians(18.0);

}  // namespace

void PastMotions::Learn(const Pose2& motion) {
  if (motions_.size() < kMostNumMotions) {
    motions_.push_back(motion);
  } else {
    motions_[num_motions_ % kMostNumMotions] = motion;
  }
  ++num_motions_;
}

bool PastMotions::SayMoreThanVelocity() const {
  return motions_.size() >= kLeastNumMotions &&
         (UsualWay(motions_) >= kLongWay || UsualTurn(motions_) >= kLongTurn);
}

bool PastMotions::HaveOneLike(const Pose2& motion) const {
  const double max_way = kLikeShareOfWay * UsualWay(motions_);
  return std::any_of(motions_.begin(), motions_.end(), [&](const Pose2& other) {
    const double turn = NormalizeAngle(other.rotation - motion.rotation) / kLikeTurn;
    return (other.translation - motion.translation).squaredNorm() / (max_way * max_way) +
               turn * turn <
           1.0;
  });
}

}  // namespace loopscope
