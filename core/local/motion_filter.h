// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/geometry/pose2.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.motion_filter.
struct MotionFilterOptions {
  double max_time_seconds = 5.0;
  double max_distance_meters = 0.2;
  double max_angle_radians = DegreesToRadians(1.0);
};

/// Drops scans that were taken too near to the last one that was kept.
class MotionFilter {
 public:
  explicit MotionFilter(const MotionFilterOptions& options) : options_(options) {}

  /// Whether to drop the scan at `time` [s]. If not, it becomes the one to compare with.
  bool IsSimilar(double time, const Pose2& local_from_base);

 private:
  MotionFilterOptions options_;
  double last_time_ = 0.0;
  std::optional<Pose2> last_local_from_base_;
};

}  // namespace loopscope
