// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/shared_jump.h"

#include <cmath>

namespace loopscope {
namespace {

/// A motion that measured nothing may still be wrong by a little.
constexpr double kLeastTurn = 1e-3;  // [rad]
constexpr double kLeastWay = 1e-3;   // [m]

double TurnOf(const Pose2& motion) { return kLeastTurn + std::abs(motion.rotation); }
double WayOf(const Pose2& motion) { return kLeastWay + motion.translation.norm(); }

}  // namespace

Pose2 FirstOfSharedJump(const Pose2& local_from_last,
                        const std::vector<Pose2>& local_from_predicted,
                        const Pose2& local_from_found) {
  std::vector<Pose2> motions;
  double turn = 0.0;
  double way = 0.0;
  Pose2 before = local_from_last;
  for (const Pose2& pose : local_from_predicted) {
    motions.push_back(before.Inverse() * pose);
    turn += TurnOf(motions.back());
    way += WayOf(motions.back());
    before = pose;
  }

  const double missing_turn = NormalizeAngle(local_from_found.rotation - before.rotation);
  std::vector<Pose2> local_from_turned;
  before = local_from_last;
  for (const Pose2& motion : motions) {
    const double extra_turn = TurnOf(motion) / turn * missing_turn;
    before = before * Pose2(motion.translation, motion.rotation + extra_turn);
    local_from_turned.push_back(before);
  }

  Pose2 first = local_from_turned.front();
  const Eigen::Vector2d missing_way =
      local_from_found.translation - local_from_turned.back().translation;
  first.translation += WayOf(motions.front()) / way * missing_way;
  return first;
}

}  // namespace loopscope
