// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/graph/pose_graph_options.h"
#include "core/local/local_slam_options.h"

namespace loopscope {

/// Everything that shapes a map. Number of threads and the like are not here: they shape none.
struct Options {
  LocalSlamOptions trajectory_builder_2d;
  PoseGraphOptions pose_graph;
};

/// Cartographer's stock values: what an `include` of its stock files resolves to.
Options CartographerPreset();

/// Ours, used when nothing else is said: maps every log well, untuned.
Options LoopscopePreset();

}  // namespace loopscope
