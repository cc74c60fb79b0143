// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/evaluation/statistics.h"
#include "core/geometry/pose2.h"
#include "core/geometry/trajectory.h"

namespace loopscope {

/// Two poses of the same time, one of a reference, one estimated.
struct PosePair {
  double time = 0.0;  ///< [s]
  Pose2 reference_from_base;
  Pose2 map_from_base;
};

/// A pair for every pose of `reference` whose time lies within `estimate`, which is interpolated.
std::vector<PosePair> PairByTime(const Trajectory& reference, const Trajectory& estimate);

/// The motion that brings the translations of the estimates nearest to those of the reference in
/// the sense of least squares: Umeyama, PAMI 13, 1991, in the plane and without scale; or Horn
/// 1987. `pairs` must not be empty. Positions of a robot that stood still, to 1 mm, tell no
/// rotation: then it is the mean of what headings differ by.
Pose2 AlignToReference(const std::vector<PosePair>& pairs);

/// How far an estimate is from its reference.
struct PoseError {
  double translation = 0.0;  ///< [m]
  double rotation = 0.0;     ///< [rad], 0 or more
};

/// Of the estimate once it is aligned.
PoseError ErrorOf(const PosePair& pair, const Pose2& reference_from_map);

/// Absolute trajectory error after alignment.
struct TrajectoryError {
  Pose2 reference_from_map;  ///< the alignment
  Statistics translation;    ///< [m]
  Statistics rotation;       ///< [rad]
};

/// Nothing if no pose of the reference lies within the time of the estimate.
std::optional<TrajectoryError> EvaluateTrajectory(const Trajectory& reference,
                                                  const Trajectory& estimate);

}  // namespace loopscope
