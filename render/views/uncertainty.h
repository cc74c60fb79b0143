// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/slam/recording.h"
#include "core/slam/state.h"
#include "render/layers/covariance.h"

namespace loopscope {

/// How sure the places of the submaps are, given that submap 0 is where it is; of at most
/// `max_count` of them, evenly spread and the last one among them.
std::vector<UncertainPoint> UncertaintyOfSubmaps(const Recording& recording, const MapState& state,
                                                 int max_count);

/// 1, 2 or 5 times a power of ten: as large as it may be so that the largest of the ellipses of so
/// many deviations has no larger a radius than `max_radius` [m]. 1 if there is no uncertainty.
double EllipseFactor(const std::vector<UncertainPoint>& points, double max_radius);

}  // namespace loopscope
