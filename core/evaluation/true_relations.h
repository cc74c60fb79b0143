// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/evaluation/relations.h"

namespace loopscope {

/// Relations between poses of a trajectory that is taken as true, as people make them by hand: from
/// each keyframe (one a metre) to the next one, and from the nearest earlier keyframe at the same
/// place, if the robot had been away in between.
std::vector<Relation> TrueRelations(const Trajectory& ground_truth);

}  // namespace loopscope
