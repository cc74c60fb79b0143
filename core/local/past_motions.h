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

  /// Whether there are fewer than twenty of them.
  bool AreFew() const;

  /// Whether they are not few, and so long that the velocity says little.
  bool SayMoreThanVelocity() const;

  /// Whether one of the last three hundred differed from `motion` by no more than three quarters of
  /// the usual way, which counts as 0.3 m at least, and 18 deg, in all.
  bool HaveOneLike(const Pose2& motion) const;

  /// The last three hundred count. While they are few, so do those that any robot on wheels might
  /// make between scans that are far apart: 0 to 2 m ahead, and up to 60 deg to each side.
  MotionPrior Prior(double exponent) const;

 private:
  std::vector<Pose2> motions_;  ///< the last of them, in no order
  std::size_t num_motions_ = 0;
};

}  // namespace loopscope
