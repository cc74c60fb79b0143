// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/evaluation.h"

#include <algorithm>
#include <stdexcept>

#include "app/cli/run_arguments.h"
#include "core/io/recording_file.h"
#include "core/io/tum_file.h"
#include "core/slam/trajectories.h"

namespace loopscope {
namespace {

/// A relation whose times are outside of the run's is judged at its ends. One at least must not be.
void RequireRelationsDuring(const EvaluatedRun& run, const std::vector<Relation>& relations) {
  const auto is_during_run = [&](const Relation& relation) {
    return relation.second_time >= run.trajectory.front().time &&
           relation.first_time <= run.trajectory.back().time;
  };
  if (!run.trajectory.empty() && std::any_of(relations.begin(), relations.end(), is_during_run)) {
    return;
  }
  throw std::invalid_argument(run.path +
                              ": its times have nothing in common with those of the relations");
}

void CompareWithReference(const EvaluatedRun& run, const Truth& truth, Evaluation* evaluation) {
  evaluation->trajectory = EvaluateTrajectory(truth.reference, run.trajectory);
  if (!evaluation->trajectory) {
    throw std::invalid_argument(run.path +
                                ": its times have nothing in common with those of the reference");
  }
  evaluation->relative = EvaluateRelative(PairByTime(truth.reference, run.trajectory), truth.delta);
}

}  // namespace

EvaluatedRun LoadRun(const std::string& path) {
  if (!IsRecording(path)) return {path, std::nullopt, ReadTum(path)};
  EvaluatedRun run{path, ReadRun(path), {}};
  run.trajectory = DenseTrajectory(*run.recording, StateOf(*run.recording, std::nullopt));
  return run;
}

Evaluation Evaluate(const EvaluatedRun& run, const Truth& truth) {
  if (!run.recording && truth.empty()) {
    throw std::invalid_argument(run.path +
                                ": nothing to compare a trajectory with; expected --relations or "
                                "--reference");
  }
  Evaluation evaluation;
  evaluation.run = run.path;
  if (!truth.relations.empty()) {
    RequireRelationsDuring(run, truth.relations);
    evaluation.relations = EvaluateRelations(truth.relations, run.trajectory);
  }
  if (!truth.reference.empty()) CompareWithReference(run, truth, &evaluation);
  if (run.recording) {
    const MapState state = StateOf(*run.recording, std::nullopt);
    ReferencePoses reference;
    if (!truth.reference.empty()) {
      reference = ReferencePosesOfNodes(*run.recording, truth.reference);
    }
    evaluation.loops = EvaluateLoops(*run.recording, state, reference, truth.loop_tolerance);
    evaluation.map = EvaluateMap(*run.recording, state);
  }
  return evaluation;
}

}  // namespace loopscope
