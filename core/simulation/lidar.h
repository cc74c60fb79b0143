// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "core/sensor/scan_log.h"
#include "core/simulation/random.h"
#include "core/simulation/ray_caster.h"

namespace loopscope {

/// A planar laser scanner and its faults.
struct LidarOptions {
  BeamGeometry beams{361, DegreesToRadians(-90.0), DegreesToRadians(0.5)};
  double max_range = 30.0;             ///< [m] beyond, nothing comes back
  double range_noise = 0.01;           ///< [m] standard deviation of a reading
  double range_step = 0.01;            ///< [m] readings are multiples of it; above zero
  double dropout_probability = 0.003;  ///< that a beam is lost for no reason, in [0, 1]
};

/// The readings of one revolution taken from `world_from_laser`, in an instant.
std::vector<float> SimulateScan(const RayCaster& ray_caster, const Pose2& world_from_laser,
                                const LidarOptions& options, Random* random);

}  // namespace loopscope
