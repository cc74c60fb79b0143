// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "core/grid/probability_grid.h"
#include "core/sensor/range_data.h"
#include "core/simulation/random.h"

namespace loopscope {

// Random numbers are drawn within braces, which fix the order; parentheses leave it to the
// compiler.

/// A grid of a few straight walls in a litter of other probabilities and holes, and a scan that
/// fits to it at `submap_from_scan`, but for some points.
struct RandomWorld {
  ProbabilityGrid grid{0.05};
  PointCloud points_in_scan;
  Pose2 submap_from_scan;
};

/// The tenths of probability of the cells of `box`, row by row; 0 is unknown.
inline std::vector<int> RandomTenths(const CellBox& box, Random* random) {
  std::vector<int> tenths(box.num_cells());
  for (int& cell : tenths) cell = random->Below(4) == 0 ? 0 : 1 + random->Below(5);
  for (int wall = 0; wall < 4; ++wall) {
    const Eigen::Vector2d size(box.width, box.height);
    const Eigen::Vector2d from =
        size.cwiseProduct(Eigen::Vector2d{random->Uniform(), random->Uniform()});
    const Eigen::Vector2d to =
        size.cwiseProduct(Eigen::Vector2d{random->Uniform(), random->Uniform()});
    for (double t = 0.0; t < 1.0; t += 0.01) {
      const Eigen::Vector2d place = from + t * (to - from);
      tenths[static_cast<int>(place.y()) * box.width + static_cast<int>(place.x())] =
          7 + random->Below(3);
    }
  }
  return tenths;
}

inline CellBox RandomBox(Random* random) {
  return {{random->Below(80) - 60, random->Below(80) - 60},
          20 + random->Below(30),
          20 + random->Below(30)};
}

inline ProbabilityGrid RandomGrid(Random* random) {
  const CellBox box = RandomBox(random);
  const std::vector<int> tenths = RandomTenths(box, random);
  ProbabilityGrid grid(0.05);
  grid.GrowToInclude(box);
  for (int value = 1; value <= 9; ++value) {
    std::vector<CellIndex> cells;
    for (int i = 0; i < box.num_cells(); ++i) {
      if (tenths[i] == value)
        cells.push_back({box.min.x + i % box.width, box.min.y + i / box.width});
    }
    grid.Update(cells, OddsUpdate(0.1 * value));
  }
  return grid;
}

inline RandomWorld MakeRandomWorld(Random* random) {
  RandomWorld world;
  world.grid = RandomGrid(random);
  const CellBox& box = world.grid.box();
  const double r = world.grid.resolution();
  const Eigen::Vector2d middle =
      r * Eigen::Vector2d(box.min.x + 0.5 * box.width, box.min.y + 0.5 * box.height);
  world.submap_from_scan =
      Pose2{middle + Eigen::Vector2d{random->Uniform(-0.3, 0.3), random->Uniform(-0.3, 0.3)},
            random->Uniform(-M_PI, M_PI)};
  while (world.points_in_scan.size() < 25) {
    const CellIndex cell{box.min.x + random->Below(box.width),
                         box.min.y + random->Below(box.height)};
    const bool stray = random->Below(200) == 0;
    if (!stray && world.grid.probability(cell) < 0.65) continue;
    const Eigen::Vector2d jitter{random->Uniform(-0.4, 0.4) * r, random->Uniform(-0.4, 0.4) * r};
    world.points_in_scan.push_back(world.submap_from_scan.Inverse() * (CenterOf(cell, r) + jitter));
  }
  return world;
}

}  // namespace loopscope
