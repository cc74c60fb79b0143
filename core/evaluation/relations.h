// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/evaluation/statistics.h"
#include "core/geometry/pose2.h"
#include "core/geometry/trajectory.h"

namespace loopscope {

/// A true relative pose, as people checked it by matching scans by hand: Kuemmerle et al., "On
/// Measuring the Accuracy of SLAM Algorithms", Autonomous Robots 27, 2009.
struct Relation {
  double first_time = 0.0;   ///< [s]
  double second_time = 0.0;  ///< [s]
  Pose2 first_from_second;   ///< the robot at second_time seen from the robot at first_time
};

/// How far a trajectory is from the relations.
struct RelationsError {
  Statistics translation;          ///< [m]
  Statistics translation_apart;    ///< [m] of the displacements alone, see DisplacementErrorOf
  Statistics translation_squared;  ///< [m^2]
  Statistics rotation;             ///< [rad]
  Statistics rotation_squared;     ///< [rad^2]
};

/// What a trajectory has wrong about one relation: (pose1^-1 * pose2) * expected^-1, with poses
/// between those of the trajectory interpolated, and times outside of it moved to its ends.
Pose2 ErrorOf(const Relation& relation, const Trajectory& trajectory);

/// How far apart pose2 seen from pose1 is from where it should be [m]. This is the translation of
/// expected^-1 * (pose1^-1 * pose2), the order in which Kuemmerle et al. pair the two: there a
/// wrong rotation does not count once more as a translation, which ErrorOf takes it for with the
/// length of the relation as lever.
double DisplacementErrorOf(const Relation& relation, const Trajectory& trajectory);

/// Over all relations, as Cartographer's compute_relations_metrics weighs them: equally.
/// `trajectory` must not be empty.
RelationsError EvaluateRelations(const std::vector<Relation>& relations,
                                 const Trajectory& trajectory);

}  // namespace loopscope
