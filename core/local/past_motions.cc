// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/past_motions.h"

namespace loopscope {
namespace {

constexpr std::size_t kLeastNumMotions = 20;
constexpr std::size_t kMostNumMotions = 300;

constexpr double kLongWay = 0.3;   // [m]
constexpr double kLongTurn = 0.1;  // [rad]

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

}  // namespace loopscope
