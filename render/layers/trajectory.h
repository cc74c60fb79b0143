// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "core/geometry/pose2.h"
#include "render/layers/shapes.h"
#include "render/palette.h"

namespace loopscope {

/// The way through `poses`.
vtkSmartPointer<vtkActor> TrajectoryLayer(const std::vector<Pose2>& poses, const Color& color,
                                          double line_width);

/// A dot at each pose, `colors[i]` for the pose i.
vtkSmartPointer<vtkActor> NodesLayer(const std::vector<Pose2>& poses,
                                     const std::vector<Color>& colors, double size);

/// The x and y axis of each frame, `length` [m].
vtkSmartPointer<vtkActor> FramesLayer(const std::vector<Pose2>& target_from_frame, double length,
                                      double line_width, const Palette& palette);

}  // namespace loopscope
