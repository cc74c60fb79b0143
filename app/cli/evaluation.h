// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/evaluation/loop_evaluation.h"
#include "core/evaluation/map_quality.h"
#include "core/evaluation/relations.h"
#include "core/evaluation/relative_error.h"
#include "core/evaluation/trajectory_error.h"
#include "core/slam/recording.h"

namespace loopscope {

/// What runs are compared with, as far as it was given, and how.
struct Truth {
  std::vector<Relation> relations;
  Trajectory reference;
  RelativeErrorDelta delta;
  LoopTolerance loop_tolerance = kReferenceTolerance;

  bool empty() const { return relations.empty() && reference.empty(); }
};

/// A run to be evaluated: a recording, or only a trajectory.
struct EvaluatedRun {
  std::string path;
  std::optional<Recording> recording;
  Trajectory trajectory;  ///< of a recording, the dense one
};

/// Throws FileError.
EvaluatedRun LoadRun(const std::string& path);

/// All that can be said of one run.
struct Evaluation {
  std::string run;
  std::optional<RelationsError> relations;
  std::optional<TrajectoryError> trajectory;
  std::optional<RelativeError> relative;
  std::optional<LoopEvaluation> loops;
  std::optional<MapQuality> map;
};

/// Throws std::invalid_argument if there is nothing to say of the run, or the reference is of
/// another time.
Evaluation Evaluate(const EvaluatedRun& run, const Truth& truth);

}  // namespace loopscope
