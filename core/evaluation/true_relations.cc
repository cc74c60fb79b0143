// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/true_relations.h"

#include <optional>

namespace loopscope {
namespace {

double Distance(const TimedPose& a, const TimedPose& b) {
  return (a.map_from_base.translation - b.map_from_base.translation).norm();
}

Trajectory Keyframes(const Trajectory& trajectory) {
  constexpr double kSpacing = 1.0;  // [m]
  Trajectory keyframes;
  for (const TimedPose& pose : trajectory) {
    if (keyframes.empty() || Distance(pose, keyframes.back()) >= kSpacing) {
      keyframes.push_back(pose);
    }
  }
  return keyframes;
}

// The nearest keyframe of an earlier visit to the place of keyframe `i`.
std::optional<size_t> EarlierVisit(const Trajectory& keyframes, size_t i) {
  constexpr double kSamePlace = 1.0;  // [m]
  constexpr size_t kNumKeyframesAway = 8;
  std::optional<size_t> nearest;
  double nearest_distance = kSamePlace;
  for (size_t j = 0; j + kNumKeyframesAway <= i; ++j) {
    const double distance = Distance(keyframes[j], keyframes[i]);
    if (distance > nearest_distance) continue;
    nearest = j;
    nearest_distance = distance;
  }
  return nearest;
}

Relation RelationBetween(const TimedPose& first, const TimedPose& second) {
  return {first.time, second.time, first.map_from_base.Inverse() * second.map_from_base};
}

}  // namespace

std::vector<Relation> TrueRelations(const Trajectory& ground_truth) {
  const Trajectory keyframes = Keyframes(ground_truth);
  std::vector<Relation> relations;
  for (size_t i = 1; i < keyframes.size(); ++i) {
    relations.push_back(RelationBetween(keyframes[i - 1], keyframes[i]));
    const std::optional<size_t> earlier = EarlierVisit(keyframes, i);
    if (earlier) relations.push_back(RelationBetween(keyframes[*earlier], keyframes[i]));
  }
  return relations;
}

}  // namespace loopscope
