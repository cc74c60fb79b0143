// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/floor_plan.h"

namespace loopscope {

/// Answers how far one sees in a floor plan. The segments are sorted into square buckets, so that a
/// ray meets only those near to its way.
class RayCaster {
 public:
  explicit RayCaster(const FloorPlan& plan);

  /// Distance [m] from `origin` to the first segment in the direction `angle` [rad] of the world,
  /// if there is one within `max_range` [m]. From outside of the plan's bounds nothing is seen.
  std::optional<double> Distance(const Eigen::Vector2d& origin, double angle,
                                 double max_range) const;

 private:
  const std::vector<int>& Bucket(int x, int y) const { return buckets_[y * width_ + x]; }
  void SortIntoBuckets(int segment);

  std::vector<Segment> segments_;
  Eigen::Vector2d low_ = Eigen::Vector2d::Zero();  ///< lower corner of bucket (0, 0)
  int width_ = 1;                                  ///< in buckets
  int height_ = 1;
  std::vector<std::vector<int>> buckets_;  ///< indices into segments_, row by row
};

/// Distance [m] along `direction` (of length 1) from `origin` to `segment`, if the ray meets it.
std::optional<double> Intersect(const Eigen::Vector2d& origin, const Eigen::Vector2d& direction,
                                const Segment& segment);

}  // namespace loopscope
