// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/search_lattice.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

double AngularStep(const PointCloud& points_in_scan, double resolution) {
  double max_square = 0.0;
  for (const Eigen::Vector2d& point : points_in_scan) {
    max_square = std::max(max_square, point.squaredNorm());
  }
  // A scan all of whose points are within a few cells has no use for larger steps.
  const double max_range = std::max(3.0 * resolution, std::sqrt(max_square));
  const double ratio = resolution / max_range;
  return std::acos(1.0 - 0.5 * ratio * ratio);
}

int NumLinearSteps(double linear_window, double resolution) {
  return static_cast<int>(std::ceil(linear_window / resolution));
}

SearchWindow MakeSearchWindow(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                              double linear_window, double angular_window, double resolution) {
  SearchWindow window;
  window.submap_from_scan_guess = submap_from_scan_guess;
  window.resolution = resolution;
  window.angular_step = AngularStep(points_in_scan, resolution);
  window.num_linear_steps = NumLinearSteps(linear_window, resolution);
  window.num_angular_steps = static_cast<int>(std::ceil(angular_window / window.angular_step));
  return window;
}

double NumPoses(const SearchWindow& window) {
  const double linear = 2.0 * window.num_linear_steps + 1.0;
  return linear * linear * (2.0 * window.num_angular_steps + 1.0);
}

Pose2 PoseInWindow(const SearchWindow& window, CellIndex offset, int angle_index) {
  const Pose2& guess = window.submap_from_scan_guess;
  return Pose2(guess.translation + CenterOf(offset, window.resolution),
               NormalizeAngle(guess.rotation + angle_index * window.angular_step));
}

}  // namespace loopscope
