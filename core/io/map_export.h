// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/slam/occupancy_map.h"

namespace loopscope {

/// What the pixels of an exported map are.
enum class MapPixels {
  kTrinary,  ///< 254 free (below 0.196), 0 occupied (above 0.65), 205 anything else
  kGreys,    ///< 255 (1 - probability), 205 only where nothing is known
};

/// Where an exported map went.
struct MapFiles {
  std::string image;  ///< .pgm
  std::string yaml;   ///< beside it, the last extension replaced by .yaml
};

/// Writes a map as ROS' map_server does: a PGM whose rows go from the top, and a YAML that says
/// where its lower left corner is. `path` names one of the two, or both without extension. Throws
/// FileError if that cannot be done.
MapFiles ExportMap(const OccupancyMap& map, MapPixels pixels, const std::string& path);

}  // namespace loopscope
