// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "core/geometry/pose2.h"

namespace loopscope {

/// How likely a robot is to have made a motion, judged by those it made before, as the weight of a
/// pose in a search: the density of the motions before, in parts of the highest, to the power of an
/// exponent. The density is that of a blurred histogram (Parzen, "On Estimation of a Probability
/// Density Function and Mode", 1962). Its bins are a sixth as wide as the robot usually moves,
/// along x and y, and 4 deg of turn; it reaches three times as far as is usual, and 90 deg.
///
/// A motion is that of the robot from one scan to the next, in the frame of the first.
class MotionPrior {
 public:
  /// `motions` must not be empty. Motions unlike any of them have the density 1e-5.
  MotionPrior(const std::vector<Pose2>& motions, double exponent);

  /// [m] in x and in y. What lies beyond has no bin.
  double reach() const { return kNumSteps * step_; }
  static constexpr double kAngularReach = DegreesToRadians(90.0);

  /// Of a translation [m], in [0, kNumPlaces), or of a turn [rad], in [0, kNumTurns).
  std::optional<int> PlaceBin(const Eigen::Vector2d& translation) const;
  std::optional<int> TurnBin(double turn) const;

  /// In (0, 1]; 1 for the likeliest.
  float Weight(int place_bin, int turn_bin) const {
    return weights_[turn_bin * kNumPlaces + place_bin];
  }

  static constexpr int kNumSteps = 20;
  static constexpr int kSide = 2 * kNumSteps + 1;
  static constexpr int kNumPlaces = kSide * kSide;
  static constexpr int kNumAngularSteps = 23;
  static constexpr int kNumTurns = 2 * kNumAngularSteps + 1;

 private:
  double step_;  ///< [m]
  std::vector<float> weights_;
};

/// Root mean square of the ways [m] and of the turns [rad] of `motions`, which must not be empty.
double UsualWay(const std::vector<Pose2>& motions);
double UsualTurn(const std::vector<Pose2>& motions);

}  // namespace loopscope
