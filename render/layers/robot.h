// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "render/palette.h"

namespace loopscope {

/// A triangle around the robot with its tip ahead, `size` from tip to tail.
std::vector<Eigen::Vector2d> RobotOutline(const Pose2& target_from_base, double size);

/// The robot as a filled mark. `size` and `edge_width` [m] are those of the triangle and of the
/// bright line around it.
vtkSmartPointer<vtkActor> RobotLayer(const Pose2& target_from_base, double size, double edge_width,
                                     const Color& color);

}  // namespace loopscope
