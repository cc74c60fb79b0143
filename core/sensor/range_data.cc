// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/sensor/range_data.h"

#include <cmath>

namespace loopscope {

RangeData ToRangeData(const LaserScan& scan, const BeamGeometry& beams,
                      const Pose2& base_from_laser, const RangeOptions& options) {
  RangeData data;  // as the laser sees it
  data.returns.reserve(scan.ranges.size());
  const auto point_at = [&](int beam, double range) {
    const double angle = beams.Angle(beam);
    return Eigen::Vector2d(range * std::cos(angle), range * std::sin(angle));
  };
  for (int beam = 0; beam < static_cast<int>(scan.ranges.size()); ++beam) {
    const double range = scan.ranges[beam];
    if (!std::isfinite(range) || range <= 0.0 || range < options.min_range) continue;
    if (range <= options.max_range) {
      data.returns.push_back(point_at(beam, range));
    } else {
      data.misses.push_back(point_at(beam, options.missing_data_ray_length));
    }
  }
  return Transform(base_from_laser, data);
}

PointCloud Transform(const Pose2& target_from_source, const PointCloud& points_in_source) {
  const Eigen::Matrix2d rotation = target_from_source.RotationMatrix();
  PointCloud points;
  points.reserve(points_in_source.size());
  for (const Eigen::Vector2d& point : points_in_source) {
    points.push_back(rotation * point + target_from_source.translation);
  }
  return points;
}

RangeData Transform(const Pose2& target_from_source, const RangeData& data_in_source) {
  return RangeData{target_from_source * data_in_source.origin,
                   Transform(target_from_source, data_in_source.returns),
                   Transform(target_from_source, data_in_source.misses)};
}

}  // namespace loopscope
