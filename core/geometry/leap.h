// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/geometry/pose2.h"

namespace loopscope {

/// Whether no robot moves so from one scan to the next: by 100 m or more, further than most
/// scanners see, or so far that it cannot be computed.
inline bool IsLeap(const Pose2& motion) {
  constexpr double kFarthest = 100.0;  // [m]
  return !(motion.translation.norm() < kFarthest);
}

}  // namespace loopscope
