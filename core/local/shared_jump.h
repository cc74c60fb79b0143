// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/geometry/pose2.h"

namespace loopscope {

/// Where the first of some scans in a row was, if odometry led to `local_from_predicted` for each
/// of them from `local_from_last` on, the pose before, but the last of them turned out to be at
/// `local_from_found`. What odometry was wrong by is shared among its motions: of the rotation each
/// takes as much as it turned, of what is missing then in translation as much as it moved.
/// `local_from_predicted` must not be empty.
Pose2 FirstOfSharedJump(const Pose2& local_from_last,
                        const std::vector<Pose2>& local_from_predicted,
                        const Pose2& local_from_found);

}  // namespace loopscope
