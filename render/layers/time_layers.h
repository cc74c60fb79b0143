// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "core/slam/recording.h"
#include "render/layers/constraints.h"
#include "render/palette.h"

namespace loopscope {

/// Height over the map for times of a run: 0 at its first scan.
struct TimeScale {
  double first_time = 0.0;         ///< stamp [s]
  double meters_per_second = 1.0;  ///< of height

  double HeightAt(double stamp) const { return meters_per_second * (stamp - first_time); }
};

/// The scale by which the whole run is `share` times as high as its nodes lie apart. It is the same
/// for all steps, so that pictures of them can be compared.
TimeScale TimeScaleOf(const Recording& recording, double share);

/// Heights of the first `count` nodes, and of submaps: that of their first node.
std::vector<double> HeightsOfNodes(const Recording& recording, const TimeScale& scale, int count);
std::vector<double> HeightsOfSubmaps(const Recording& recording, const TimeScale& scale, int count);

/// The way through `poses`, each at its height.
vtkSmartPointer<vtkActor> RisingTrajectoryLayer(const std::vector<Pose2>& poses,
                                                const std::vector<double>& heights,
                                                const Color& color, double line_width);

/// A dot at each pose, at its height.
vtkSmartPointer<vtkActor> RisingNodesLayer(const std::vector<Pose2>& poses,
                                           const std::vector<double>& heights, const Color& color,
                                           double size);

/// The x and y axis of each frame, `length` [m], at its height.
vtkSmartPointer<vtkActor> RisingFramesLayer(const std::vector<Pose2>& map_from_frame,
                                            const std::vector<double>& heights, double length,
                                            double line_width, const Palette& palette);

/// A line from each submap to the expected place of its node, from the height of one to that of the
/// other. The colours are those of the submaps if there is no `color`.
vtkSmartPointer<vtkActor> RisingConstraintsLayer(const std::vector<PlacedConstraint>& constraints,
                                                 const std::vector<double>& submap_heights,
                                                 const std::vector<double>& node_heights,
                                                 const std::optional<Color>& color, double opacity,
                                                 double line_width);

/// Seconds at which an axis up to `duration` [s] has ticks: 0 and a few multiples of 1, 2 or 5
/// times a power of ten.
std::vector<double> TicksUpTo(double duration);

}  // namespace loopscope
