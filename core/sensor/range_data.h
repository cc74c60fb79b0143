// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "core/sensor/scan_log.h"

namespace loopscope {

using PointCloud = std::vector<Eigen::Vector2d>;  ///< [m]

/// What one scan says about the world, all in one frame. Rays begin at `origin`, the scanner.
struct RangeData {
  Eigen::Vector2d origin = Eigen::Vector2d::Zero();
  PointCloud returns;  ///< where a beam met something
  PointCloud misses;   ///< ends of the free part of beams that met nothing within the range used
};

/// TRAJECTORY_BUILDER_2D: which readings are used.
struct RangeOptions {
  double min_range = 0.0;                ///< [m] nearer readings are dropped
  double max_range = 30.0;               ///< [m] farther ones become misses
  double missing_data_ray_length = 5.0;  ///< [m] length given to such a miss
};

/// The readings of `scan` in the frame of the robot. Readings without return (+infinity) and
/// invalid ones (NaN, not above zero) give nothing: a scanner also reads "nothing" off black and
/// off glass.
RangeData ToRangeData(const LaserScan& scan, const BeamGeometry& beams,
                      const Pose2& base_from_laser, const RangeOptions& options);

PointCloud Transform(const Pose2& target_from_source, const PointCloud& points_in_source);
RangeData Transform(const Pose2& target_from_source, const RangeData& data_in_source);

}  // namespace loopscope
