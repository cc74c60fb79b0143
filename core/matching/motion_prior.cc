// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/motion_prior.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

namespace loopscope {
namespace {

constexpr double kUsualWayInSteps = 6.0;
constexpr double kLeastStep = 0.05;  // [m]
constexpr double kMostStep = 0.5;    // [m]
constexpr double kTurnStep = DegreesToRadians(4.0);

constexpr double kBlur = 1.5;  // standard deviation [bins]
constexpr int kBlurReach = 5;  // [bins]

constexpr float kLeastDensity = 1e-5F;

std::optional<int> BinOf(double value, double step, int num_steps) {
  const double bin = std::round(value / step);
  if (!(std::abs(bin) <= num_steps)) return std::nullopt;
  return static_cast<int>(bin) + num_steps;
}

/// Along one of the axes: its entries are `stride` apart, and there are `size` of them.
std::vector<float> Blurred(const std::vector<float>& density, int stride, int size) {
  std::vector<float> kernel(kBlurReach + 1);
  for (int i = 0; i <= kBlurReach; ++i) {
    kernel[i] = static_cast<float>(std::exp(-0.5 * i * i / (kBlur * kBlur)));
  }
  std::vector<float> blurred(density.size(), 0.0F);
  for (int i = 0; i < static_cast<int>(density.size()); ++i) {
    if (density[i] == 0.0F) continue;
    const int position = i / stride % size;
    const int last = std::min(kBlurReach, size - 1 - position);
    for (int shift = -std::min(kBlurReach, position); shift <= last; ++shift) {
      blurred[i + shift * stride] += kernel[std::abs(shift)] * density[i];
    }
  }
  return blurred;
}

}  // namespace

double UsualWay(const std::vector<Pose2>& motions) {
  assert(!motions.empty());
  double sum = 0.0;
  for (const Pose2& motion : motions) sum += motion.translation.squaredNorm();
  return std::sqrt(sum / static_cast<double>(motions.size()));
}

double UsualTurn(const std::vector<Pose2>& motions) {
  assert(!motions.empty());
  double sum = 0.0;
  for (const Pose2& motion : motions) {
    const double turn = NormalizeAngle(motion.rotation);
    sum += turn * turn;
  }
  return std::sqrt(sum / static_cast<double>(motions.size()));
}

MotionPrior::MotionPrior(const std::vector<Pose2>& motions, double exponent)
    : step_(std::clamp(UsualWay(motions) / kUsualWayInSteps, kLeastStep, kMostStep)),
      weights_(kNumTurns * kNumPlaces, 0.0F) {
  for (const Pose2& motion : motions) {
    const auto place = PlaceBin(motion.translation);
    const auto turn = TurnBin(motion.rotation);
    if (place && turn) ++weights_[*turn * kNumPlaces + *place];
  }
  weights_ = Blurred(weights_, 1, kSide);
  weights_ = Blurred(weights_, kSide, kSide);
  weights_ = Blurred(weights_, kNumPlaces, kNumTurns);
  const float highest = std::max(*std::max_element(weights_.begin(), weights_.end()), 1.0F);
  for (float& weight : weights_) {
    weight = std::pow(std::max(weight / highest, kLeastDensity), static_cast<float>(exponent));
  }
}

std::optional<int> MotionPrior::PlaceBin(const Eigen::Vector2d& translation) const {
  const auto x = BinOf(translation.x(), step_, kNumSteps);
  const auto y = BinOf(translation.y(), step_, kNumSteps);
  if (!x || !y) return std::nullopt;
  return *y * kSide + *x;
}

std::optional<int> MotionPrior::TurnBin(double turn) const {
  return BinOf(NormalizeAngle(turn), kTurnStep, kNumAngularSteps);
}

}  // namespace loopscope
