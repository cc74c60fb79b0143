// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/drift_share.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

constexpr std::size_t kMinLoops = 30;
constexpr double kQuantile = 0.95;
constexpr double kSafety = 3.0;
constexpr int kAllOfWindowEvery = 8;

double Predict(std::vector<double> taken, const MeasuredDriftOptions& options) {
  const auto quantile =
      taken.begin() + static_cast<std::ptrdiff_t>(kQuantile * static_cast<double>(taken.size()));
  std::nth_element(taken.begin(), quantile, taken.end());
  return std::clamp(kSafety * *quantile, options.min_window_share, 1.0);
}

}  // namespace

double ShareOfWindow(double part, double window) { return window > 0.0 ? part / window : 1.0; }

DriftShare DriftShareOf(const Pose2& guess, const Pose2& found, const LoopGate& gate) {
  const Pose2 drift = guess.Inverse() * found;
  return {ShareOfWindow(drift.translation.norm(), gate.linear_window),
          ShareOfWindow(std::abs(NormalizeAngle(drift.rotation)), gate.angular_window)};
}

DriftShare PredictDriftShare(const std::vector<DriftShare>& taken,
                             const MeasuredDriftOptions& options) {
  if (taken.size() < kMinLoops) return DriftShare{};
  std::vector<double> linear;
  std::vector<double> angular;
  for (const DriftShare& share : taken) {
    linear.push_back(share.linear);
    angular.push_back(share.angular);
  }
  return {Predict(std::move(linear), options), Predict(std::move(angular), options)};
}

LoopCandidate WithDriftShare(LoopCandidate candidate, const DriftShare& share) {
  if (candidate.node.index % kAllOfWindowEvery == 0) return candidate;
  candidate.linear_search_window *= share.linear;
  candidate.angular_search_window *= share.angular;
  return candidate;
}

}  // namespace loopscope
