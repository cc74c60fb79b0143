// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "render/layers/shapes.h"
#include "render/scene.h"

namespace loopscope {

/// Diagonal lines over `area`, parts of one pattern with lines `spacing` apart, so that the lines
/// of areas side by side go on in each other.
void AddHatch(const Extent& area, double spacing, const Color& color, Shapes* shapes);

vtkSmartPointer<vtkActor> HatchLayer(const std::vector<Extent>& areas, double spacing,
                                     const Color& color, double line_width);

}  // namespace loopscope
