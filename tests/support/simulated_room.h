// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <memory>

#include "core/grid/ray_cast.h"
#include "core/grid/scan_inserter.h"
#include "core/simulation/lidar.h"
#include "core/simulation/ray_caster.h"

namespace loopscope {

/// A scan with these returns, by a scanner in the middle of the robot.
inline std::shared_ptr<const RangeData> ScanOf(const PointCloud& points_in_node) {
  RangeData scan;
  scan.returns = points_in_node;
  return std::make_shared<const RangeData>(scan);
}

/// A furnished room of 6 m x 5 m, mapped from three places. The frames of the room and of the
/// submap are the same; its lower left corner is at (-1 m, -2 m).
class SimulatedRoom {
 public:
  SimulatedRoom() : ray_caster_(Plan()) {
    const ScanInserter inserter({0.7, 0.4, true});
    for (const Pose2& pose : {Pose2(1.0, 0.5, 0.0), Pose2(3.5, 1.5, 2.0), Pose2(4.2, -1.2, -1.0)}) {
      for (int i = 0; i < 3; ++i) {
        RangeData data;
        data.returns = ScanAt(pose);
        inserter.Insert(CastRays(Transform(pose, data), grid_.resolution()), &grid_);
      }
    }
  }

  const ProbabilityGrid& grid() const { return grid_; }

  /// What a scanner without noise sees all around it, in its own frame.
  PointCloud ScanAt(const Pose2& submap_from_scan) const {
    LidarOptions lidar;
    lidar.beams = {720, -M_PI, DegreesToRadians(0.5)};
    lidar.range_noise = 0.0;
    lidar.range_step = 1e-3;
    lidar.dropout_probability = 0.0;
    Random random(1);
    LaserScan scan;
    scan.ranges = SimulateScan(ray_caster_, submap_from_scan, lidar, &random);
    return ToRangeData(scan, lidar.beams, Pose2(), RangeOptions()).returns;
  }

 private:
  static FloorPlan Plan() {
    FloorPlan plan;
    plan.AddRoom({-1.0, -2.0}, {5.0, 3.0});
    plan.AddBox(Pose2(0.2, 2.4, 0.3), {1.2, 0.5});
    plan.AddBox(Pose2(2.3, -1.4, 0.0), {0.6, 0.8});
    plan.AddPillar({4.2, 0.4}, 0.3);
    return plan;
  }

  RayCaster ray_caster_;
  ProbabilityGrid grid_{0.05};
};

}  // namespace loopscope
