// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/motion_filter.h"

#include <cmath>

namespace loopscope {

bool MotionFilter::IsSimilar(double time, const Pose2& local_from_base) {
  if (last_local_from_base_) {
    const Pose2 motion = last_local_from_base_->Inverse() * local_from_base;
    if (std::abs(time - last_time_) <= options_.max_time_seconds &&
        motion.translation.norm() <= options_.max_distance_meters &&
        std::abs(motion.rotation) <= options_.max_angle_radians) {
      return true;
    }
  }
  last_time_ = time;
  last_local_from_base_ = local_from_base;
  return false;
}

}  // namespace loopscope
