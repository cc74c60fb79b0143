// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "render/palette.h"
#include "render/scene.h"

namespace loopscope {

/// The edge of `extent`, `line_width` [px] wide.
vtkSmartPointer<vtkActor> OutlineLayer(const Extent& extent, const Color& color, double line_width);

/// A circle, its radius in the units of the panel and its line `line_width` [px] wide.
vtkSmartPointer<vtkActor> CircleLayer(const Eigen::Vector2d& center, double radius,
                                      const Color& color, double line_width);

}  // namespace loopscope
