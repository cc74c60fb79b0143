// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/sensor/range_data.h"
#include "core/slam/recording.h"
#include "core/slam/state.h"

namespace loopscope {

/// How crisp the points of a map are. Walls that were mapped twice beside each other, or blurred by
/// wrong poses, are thicker. Numbers of different scanners or places do not compare: range noise
/// and furniture count as well.
struct Crispness {
  /// Mean map entropy [nats], lower is better: 1/2 ln det(2 pi e Sigma) of the returns in 0.3 m
  /// around a return, averaged over returns; Droeschel, Stueckler, Behnke, "Local Multi-Resolution
  /// Representation for 6D Motion Estimation and Mapping with a Continuously Rotating 3D Laser
  /// Scanner", ICRA 2014.
  double mean_map_entropy = 0.0;
  /// Standard deviation of these returns across the wall, the root of the lesser eigenvalue of
  /// Sigma [m]: the median over the returns. It is the mean plane variance of Razlaw, Droeschel,
  /// Holz, Behnke, "Evaluation of Registration Methods for Sparse 3D Laser Scans", ECMR 2015, made
  /// robust.
  double wall_thickness = 0.0;
};

/// Of up to 5000 returns spread evenly over `points`, each with all that are around it. One that
/// has less than four others there, or all of them on a line, is left out; zeros if all are.
Crispness CrispnessOf(const PointCloud& points);

/// What can be said of a map without a reference.
struct MapQuality {
  Crispness crispness;
  /// Of what scans say of the cells that are occupied in BuildOccupancyMap, the share that is
  /// "free": other scans see through walls that poses have put in the wrong place.
  double disagreement = 0.0;
};

/// Throws std::length_error as BuildOccupancyMap does.
MapQuality EvaluateMap(const Recording& recording, const MapState& state);

}  // namespace loopscope
