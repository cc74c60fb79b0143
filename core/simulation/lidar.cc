// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/lidar.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopscope {

std::vector<float> SimulateScan(const RayCaster& ray_caster, const Pose2& world_from_laser,
                                const LidarOptions& options, Random* random) {
  std::vector<float> ranges(options.beams.num_beams, std::numeric_limits<float>::infinity());
  for (int beam = 0; beam < options.beams.num_beams; ++beam) {
    // Drawn for every beam, so that one wall more does not change the noise of all later beams.
    const bool dropped = random->Uniform() < options.dropout_probability;
    const double noise = random->Gaussian(options.range_noise);
    const auto distance = ray_caster.Distance(world_from_laser.translation,
                                              world_from_laser.rotation + options.beams.Angle(beam),
                                              options.max_range);
    if (dropped || !distance) continue;
    const double num_steps = std::round((*distance + noise) / options.range_step);
    ranges[beam] = static_cast<float>(std::max(num_steps, 1.0) * options.range_step);
  }
  return ranges;
}

}  // namespace loopscope
