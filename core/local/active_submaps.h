// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/grid/scan_inserter.h"

namespace loopscope {

/// TRAJECTORY_BUILDER_2D.submaps.
struct SubmapsOptions {
  int num_range_data = 90;          ///< a submap is finished after twice as many nodes
  double grid_resolution = 0.05;    ///< grid_options_2d.resolution, r [m]
  ScanInserterOptions range_data_inserter;
};

}  // namespace loopscope
