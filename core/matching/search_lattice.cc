// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/search_lattice.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

double AngularStep(const PointCloud& points_in_scan, double resolution) {
  // A scan all of whose points are within a few cells has no use for larger steps.
  double max_range = 3.0 * resolution;
  for (const Eigen::Vector2d& point : points_in_scan) {
    max_range = std::max(max_range, point.norm());
  }
  const double ratio = resolution / max_range;
  return std::acos(1.0 - 0.5 * ratio * ratio);
}

SearchWindow MakeSearchWindow(const PointCloud& points_in_scan, const Pose2& submap_from_scan_guess,
                              double linear_window, double angular_window, double resolution) {
  SearchWindow window;
  window.submap_from_scan_guess = submap_from_scan_guess;
  window.resolution = resolution;
  window.angular_step = AngularStep(points_in_scan, resolution);
  window.num_linear_steps = static_cast<int>(std::ceil(linear_window / resolution));
  window.num_angular_steps = static_cast<int>(std::ceil(angular_window / window.angular_step));
  return window;
}

Pose2 PoseInWindow(const SearchWindow& window, CellIndex offset, int angle_index) {
  const Pose2& guess = window.submap_from_scan_guess;
  return Pose2(guess.translation + CenterOf(offset, window.resolution),
               NormalizeAngle(guess.rotation + angle_index * window.angular_step));
}

std::vector<CellIndex> CellsAtAngle(const SearchWindow& window, const PointCloud& points_in_scan,
                                    int angle_index) {
  const Pose2 submap_from_scan = PoseInWindow(window, {0, 0}, angle_index);
  const Eigen::Matrix2d rotation = submap_from_scan.RotationMatrix();
  std::vector<CellIndex> cells;
  cells.reserve(points_in_scan.size());
  for (const Eigen::Vector2d& point : points_in_scan) {
    cells.push_back(CellOf(rotation * point + submap_from_scan.translation, window.resolution));
  }
  return cells;
}

}  // namespace loopscope
