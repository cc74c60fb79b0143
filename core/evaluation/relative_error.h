// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "core/evaluation/statistics.h"
#include "core/evaluation/trajectory_error.h"

namespace loopscope {

/// How far apart the poses are between which motions are compared: in way, or in poses; > 0.
struct DeltaInMeters {
  double meters = 1.0;
};
struct DeltaInPoses {
  int count = 1;
};
using RelativeErrorDelta = std::variant<DeltaInMeters, DeltaInPoses>;

/// Relative pose error: what (reference1^-1 * reference2)^-1 * (estimate1^-1 * estimate2) has of
/// translation and rotation; Sturm et al., "A Benchmark for the Evaluation of RGB-D SLAM Systems",
/// IROS 2012. No alignment is needed.
struct RelativeError {
  Statistics translation;  ///< [m]
  Statistics rotation;     ///< [rad]
};

/// Indices of the poses between which motions are compared, each one with the next one: as evo
/// chooses them without all_pairs. In metres they are the poses at which the estimate has gone so
/// far or more since the one before, the first pose not being one of them.
std::vector<int> RelativeErrorFrames(const std::vector<PosePair>& pairs,
                                     const RelativeErrorDelta& delta);

/// Nothing if the way is too short for a single motion.
std::optional<RelativeError> EvaluateRelative(const std::vector<PosePair>& pairs,
                                              const RelativeErrorDelta& delta);

}  // namespace loopscope
