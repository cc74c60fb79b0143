// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_errors.h"

#include <cmath>
#include <filesystem>
#include <stdexcept>

namespace loopscope {
namespace {

void AddAbsoluteErrors(const EvaluatedRun& run, const Trajectory& reference, RunErrors* errors) {
  errors->measure = "absolute trajectory error";
  const std::vector<PosePair> pairs = PairByTime(reference, run.trajectory);
  if (pairs.empty()) return;
  const Pose2 reference_from_map = AlignToReference(pairs);
  const Pose2 map_from_reference = reference_from_map.Inverse();
  for (const PosePair& pair : pairs) {
    const PoseError error = ErrorOf(pair, reference_from_map);
    errors->reference.push_back(map_from_reference * pair.reference_from_base);
    errors->samples.push_back({pair.map_from_base.translation, error.translation, error.rotation});
  }
}

void AddErrorsOfRelations(const EvaluatedRun& run, const std::vector<Relation>& relations,
                          RunErrors* errors) {
  errors->measure = "errors of relations";
  for (const Relation& relation : relations) {
    const Pose2 error = ErrorOf(relation, run.trajectory);
    errors->samples.push_back({PoseAt(run.trajectory, relation.second_time).translation,
                               error.translation.norm(), std::abs(error.rotation)});
  }
}

}  // namespace

RunErrors RunErrorsOf(const EvaluatedRun& run, const Truth& truth) {
  if (truth.empty()) {
    throw std::invalid_argument("no errors to plot; expected --relations or --reference");
  }
  RunErrors errors;
  errors.run = std::filesystem::path(run.path).filename().string();
  for (const TimedPose& pose : run.trajectory) errors.way.push_back(pose.map_from_base);
  if (run.recording) errors.recording = &*run.recording;
  if (!truth.reference.empty()) {
    AddAbsoluteErrors(run, truth.reference, &errors);
  } else {
    AddErrorsOfRelations(run, truth.relations, &errors);
  }
  return errors;
}

}  // namespace loopscope
