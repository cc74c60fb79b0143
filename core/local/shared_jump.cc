// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/shared_jump.h"

#include <cmath>

namespace loopscope {
namespace {

/// A motion that measured nothing may still be wrong by a little.
constexpr double kLeastTurn = 1e-3;  // [rad]
constexpr double kLeastWay = 1e-3;   // [m]

}  // namespace

Pose2 FirstOfSharedJump(const Pose2& local_from_last,
                        const std::vector<Pose2>& local_from_predicted,
                        const Pose2& local_from_found) {
  std::vector<Pose2> motions;
  double turn = 0.0;
  double way = 0.0;
  const Pose2* before = &local_from_last;
  for (const Pose2& pose : local_from_predicted) {
    motions.push_back(before->Inverse() * pose);
    turn += kLeastTurn + std::abs(motions.back().rotation);
    way += kLeastWay + motions.back().translation.norm();
    before = &pose;
  }
  const double missing_turn = NormalizeAngle(local_from_found.rotation - before->rotation);
  Pose2 chain = local_from_last;
  Pose2 first;
  for (Pose2& motion : motions) {
    const double share = (kLeastTurn + std::abs(motion.rotation)) / turn;
    chain = chain * Pose2(motion.translation, motion.rotation + share * missing_turn);
    if (&motion == &motions.front()) first = chain;
  }
  const double share = (kLeastWay + motions.front().translation.norm()) / way;
  first.translation += share * (local_from_found.translation - chain.translation);
  return first;
}

}  // namespace loopscope
