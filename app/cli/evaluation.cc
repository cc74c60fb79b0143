// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/evaluation.h"

#include <stdexcept>

#include "app/cli/run_arguments.h"
#include "core/io/recording_file.h"
#include "core/io/tum_file.h"
#include "core/slam/trajectories.h"

namespace loopscope {
namespace {

void CompareWithReference(const EvaluatedRun& run, const Truth& truth, Evaluation* evaluation) {
  evaluation->trajectory = EvaluateTrajectory(truth.reference, run.trajectory);
  if (!evaluation->trajectory) {
    throw std::invalid_argument(run.path +
                                ": its times have nothing in common with those of the reference");
  }
  evaluation->relative = EvaluateRelative(PairByTime(truth.reference, run.trajectory), truth.delta);
}

LoopEvaluation EvaluateLoops(const Recording& recording, const MapState& state,
                             const Truth& truth) {
  ReferencePoses reference;
  if (!truth.reference.empty()) reference = ReferencePosesOfNodes(recording, truth.reference);
  const std::vector<JudgedLoop> loops = JudgeLoops(recording, state, reference);
  LoopEvaluation evaluation;
  evaluation.counts = CountLoops(loops, truth.loop_tolerance);
  std::vector<JudgedLoop> accepted, held;  // without those that are wrong
  for (const JudgedLoop& loop : loops) {
    const bool is_wrong = IsWrong(loop, truth.loop_tolerance);
    if (is_wrong && loop.IsInForce()) evaluation.wrong.push_back(loop);
    if (!is_wrong) accepted.push_back(loop);
    if (!is_wrong && loop.IsInForce()) held.push_back(loop);
  }
  const std::vector<Revisit> revisits = RevisitsOf(recording, reference);
  evaluation.num_revisits = static_cast<int>(revisits.size());
  evaluation.num_never_accepted =
      static_cast<int>(RevisitsWithout(recording, accepted, revisits).size());
  evaluation.missed = RevisitsWithout(recording, held, revisits);
  return evaluation;
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
    evaluation.relations = EvaluateRelations(truth.relations, run.trajectory);
  }
  if (!truth.reference.empty()) CompareWithReference(run, truth, &evaluation);
  if (run.recording) {
    const MapState state = StateOf(*run.recording, std::nullopt);
    evaluation.loops = EvaluateLoops(*run.recording, state, truth);
    evaluation.map = EvaluateMap(*run.recording, state);
  }
  return evaluation;
}

}  // namespace loopscope
