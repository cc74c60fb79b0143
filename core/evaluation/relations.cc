// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/relations.h"

#include <cmath>

namespace loopscope {

namespace {

Pose2 FirstFromSecond(const Relation& relation, const Trajectory& trajectory) {
  const Pose2 map_from_first = PoseAt(trajectory, relation.first_time);
  const Pose2 map_from_second = PoseAt(trajectory, relation.second_time);
  return map_from_first.Inverse() * map_from_second;
}

}  // namespace

Pose2 ErrorOf(const Relation& relation, const Trajectory& trajectory) {
  return FirstFromSecond(relation, trajectory) * relation.first_from_second.Inverse();
}

double DisplacementErrorOf(const Relation& relation, const Trajectory& trajectory) {
  return (FirstFromSecond(relation, trajectory).translation -
          relation.first_from_second.translation)
      .norm();
}

RelationsError EvaluateRelations(const std::vector<Relation>& relations,
                                 const Trajectory& trajectory) {
  std::vector<double> translations, apart, squared_translations, rotations, squared_rotations;
  for (const Relation& relation : relations) {
    const Pose2 error = ErrorOf(relation, trajectory);
    translations.push_back(error.translation.norm());
    apart.push_back(DisplacementErrorOf(relation, trajectory));
    squared_translations.push_back(error.translation.squaredNorm());
    rotations.push_back(std::abs(error.rotation));
    squared_rotations.push_back(error.rotation * error.rotation);
  }
  return {StatisticsOf(translations), StatisticsOf(apart), StatisticsOf(squared_translations),
          StatisticsOf(rotations), StatisticsOf(squared_rotations)};
}

}  // namespace loopscope
