// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/trajectory_error.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace loopscope {
namespace {

/// [rad] From the headings of the estimates to those of the reference.
double MeanTurn(const std::vector<PosePair>& pairs) {
  double sum_of_cosines = 0.0;
  double sum_of_sines = 0.0;
  for (const PosePair& pair : pairs) {
    const double turn = pair.reference_from_base.rotation - pair.map_from_base.rotation;
    sum_of_cosines += std::cos(turn);
    sum_of_sines += std::sin(turn);
  }
  return std::atan2(sum_of_sines, sum_of_cosines);
}

}  // namespace

std::vector<PosePair> PairByTime(const Trajectory& reference, const Trajectory& estimate) {
  std::vector<PosePair> pairs;
  if (estimate.empty()) return pairs;
  for (const TimedPose& pose : reference) {
    if (pose.time < estimate.front().time || pose.time > estimate.back().time) continue;
    pairs.push_back({pose.time, pose.map_from_base, PoseAt(estimate, pose.time)});
  }
  return pairs;
}

Pose2 AlignToReference(const std::vector<PosePair>& pairs) {
  assert(!pairs.empty());
  Eigen::Vector2d reference_mean = Eigen::Vector2d::Zero();
  Eigen::Vector2d estimate_mean = Eigen::Vector2d::Zero();
  for (const PosePair& pair : pairs) {
    reference_mean += pair.reference_from_base.translation / static_cast<double>(pairs.size());
    estimate_mean += pair.map_from_base.translation / static_cast<double>(pairs.size());
  }
  // In the plane the optimal rotation is the angle of the summed products of complex numbers.
  double sum_of_dots = 0.0;
  double sum_of_crosses = 0.0;
  double estimate_squares = 0.0;
  double reference_squares = 0.0;
  for (const PosePair& pair : pairs) {
    const Eigen::Vector2d a = pair.map_from_base.translation - estimate_mean;
    const Eigen::Vector2d b = pair.reference_from_base.translation - reference_mean;
    sum_of_dots += a.dot(b);
    sum_of_crosses += a.x() * b.y() - a.y() * b.x();
    estimate_squares += a.squaredNorm();
    reference_squares += b.squaredNorm();
  }
  constexpr double kStandstill = 1e-3;  // [m]
  const bool stood_still = std::min(estimate_squares, reference_squares) <
                           static_cast<double>(pairs.size()) * kStandstill * kStandstill;
  const Pose2 rotation(0.0, 0.0,
                       stood_still ? MeanTurn(pairs) : std::atan2(sum_of_crosses, sum_of_dots));
  return Pose2(reference_mean - rotation * estimate_mean, rotation.rotation);
}

PoseError ErrorOf(const PosePair& pair, const Pose2& reference_from_map) {
  const Pose2 aligned = reference_from_map * pair.map_from_base;
  return {(aligned.translation - pair.reference_from_base.translation).norm(),
          std::abs(NormalizeAngle(aligned.rotation - pair.reference_from_base.rotation))};
}

std::optional<TrajectoryError> EvaluateTrajectory(const Trajectory& reference,
                                                  const Trajectory& estimate) {
  const std::vector<PosePair> pairs = PairByTime(reference, estimate);
  if (pairs.empty()) return std::nullopt;
  TrajectoryError error;
  error.reference_from_map = AlignToReference(pairs);
  std::vector<double> translations, rotations;
  for (const PosePair& pair : pairs) {
    const PoseError of_pose = ErrorOf(pair, error.reference_from_map);
    translations.push_back(of_pose.translation);
    rotations.push_back(of_pose.rotation);
  }
  error.translation = StatisticsOf(translations);
  error.rotation = StatisticsOf(rotations);
  return error;
}

}  // namespace loopscope
