// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/relative_error.h"

#include <cmath>

namespace loopscope {
namespace {

std::vector<int> FramesByCount(std::size_t num_poses, std::size_t count) {
  std::vector<int> frames;
  for (std::size_t i = 0; i < num_poses; i += count) frames.push_back(static_cast<int>(i));
  return frames;
}

std::vector<int> FramesByWay(const std::vector<PosePair>& pairs, double length) {
  std::vector<int> frames;
  double way = 0.0;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    way += (pairs[i].map_from_base.translation - pairs[i - 1].map_from_base.translation).norm();
    if (way < length) continue;
    frames.push_back(static_cast<int>(i));
    way = 0.0;
  }
  return frames;
}

Pose2 ErrorBetween(const PosePair& first, const PosePair& second) {
  const Pose2 expected = first.reference_from_base.Inverse() * second.reference_from_base;
  return expected.Inverse() * (first.map_from_base.Inverse() * second.map_from_base);
}

}  // namespace

std::vector<int> RelativeErrorFrames(const std::vector<PosePair>& pairs,
                                     const RelativeErrorDelta& delta) {
  if (const auto* const in_poses = std::get_if<DeltaInPoses>(&delta)) {
    return FramesByCount(pairs.size(), in_poses->count);
  }
  return FramesByWay(pairs, std::get<DeltaInMeters>(delta).meters);
}

std::optional<RelativeError> EvaluateRelative(const std::vector<PosePair>& pairs,
                                              const RelativeErrorDelta& delta) {
  const std::vector<int> frames = RelativeErrorFrames(pairs, delta);
  if (frames.size() < 2) return std::nullopt;
  std::vector<double> translations, rotations;
  for (std::size_t i = 1; i < frames.size(); ++i) {
    const Pose2 error = ErrorBetween(pairs[frames[i - 1]], pairs[frames[i]]);
    translations.push_back(error.translation.norm());
    rotations.push_back(std::abs(error.rotation));
  }
  return RelativeError{StatisticsOf(translations), StatisticsOf(rotations)};
}

}  // namespace loopscope
