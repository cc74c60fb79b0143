// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// Writes the pose graph in the text format of g2o: VERTEX_SE2 for submaps (ids from 0) and behind
/// them for nodes, at their optimized poses; EDGE_SE2 from submap to node for every INTRA_SUBMAP
/// and INTER_SUBMAP constraint but the loops that are outliers there, whose information is that of
/// eq. 4, without Huber loss; FIX for submap 0. Throws FileError if that cannot be done.
void ExportGraph(const Recording& recording, const MapState& state, const std::string& path);

}  // namespace loopscope
