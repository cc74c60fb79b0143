// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>
#include <vector>

#include <Eigen/Geometry>

namespace loopscope {

/// All pairs of boxes that are no more than `distance` apart, the later one first, in ascending
/// order. Looks only at boxes that are near in x (sort and sweep; Cohen et al., "I-COLLIDE", 1995).
std::vector<std::pair<int, int>> NearBoxes(const std::vector<Eigen::AlignedBox2d>& boxes,
                                           double distance);

}  // namespace loopscope
