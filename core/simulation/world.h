// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/simulation/floor_plan.h"

namespace loopscope {

/// A place to drive in, and a way through it that keeps clear of all that stands there.
struct World {
  std::string name;
  std::string description;  ///< one sentence
  FloorPlan plan;
  std::vector<Eigen::Vector2d> route;  ///< waypoints [m] in the frame of the world, at least two
};

/// The names that MakeWorld takes.
std::vector<std::string> WorldNames();

/// A world by its name; the same each time. Throws std::invalid_argument that lists the names if
/// there is none of this one.
World MakeWorld(const std::string& name);

}  // namespace loopscope
