// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/wall_filling.h"

#include <algorithm>
#include <cmath>

namespace loopscope {
namespace {

/// The sine of the turn that a straight line may make at a return, 5 deg.
constexpr double kMaxTurn = 0.08715574274765817;
/// The returns before and after tell the direction less well if they are farther away [gaps].
constexpr double kMaxArm = 2.0;

/// Whether the returns before and after the one at `index` lie on a straight line with it.
bool IsOnStraightLine(const PointCloud& returns, std::size_t index, double max_gap) {
  if (index == 0 || index + 1 >= returns.size()) return false;
  const Eigen::Vector2d before = returns[index] - returns[index - 1];
  const Eigen::Vector2d after = returns[index + 1] - returns[index];
  const double lengths = before.norm() * after.norm();
  if (std::max(before.norm(), after.norm()) > kMaxArm * max_gap) return false;
  const double cross = before.x() * after.y() - before.y() * after.x();
  return before.dot(after) > 0.0 && std::abs(cross) < kMaxTurn * lengths;
}

}  // namespace

PointCloud PointsBetween(const PointCloud& returns, double max_gap, double step) {
  PointCloud points;
  for (std::size_t i = 0; i + 1 < returns.size(); ++i) {
    const Eigen::Vector2d gap = returns[i + 1] - returns[i];
    const double length = gap.norm();
    if (length <= step || length > max_gap) continue;
    if (!IsOnStraightLine(returns, i, max_gap) || !IsOnStraightLine(returns, i + 1, max_gap)) {
      continue;
    }
    const int num_steps = static_cast<int>(std::ceil(length / step));
    for (int k = 1; k < num_steps; ++k) {
      points.push_back(returns[i] + gap * (static_cast<double>(k) / num_steps));
    }
  }
  return points;
}

}  // namespace loopscope
