// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/pose2.h"
#include "core/matching/motion_prior.h"

namespace loopscope {

/// How the robot moved from each scan to the next until now, as far as odometry or matching knew
/// it. Where neither odometry tells how it moves next nor the velocity, because a log has a scan
/// only every metre, or turn, it will be as it was.
class PastMotions {
 public:
  void Learn(const Pose2& motion);

  /// Whether there are twenty of them, and they are so long that the velocity says little.
  bool SayMoreThanVelocity() const;

  /// Whether one of the last three hundred differed from `motion` by no more than three quarters of
  /// the usual way, and 18 deg, in all. There must be one at least.
  bool HaveOneLike(const Pose2& motion) const;

  /// There must be one at least. The last three hundred count.
  MotionPrior Prior(double exponent) const { return MotionPrior(motions_, exponent); }

 private:
  std::vector<Pose2> motions_;  ///< the last of them, in no order
  std::size_t num_motions_ = 0;
};

}  // namespace loopscope
