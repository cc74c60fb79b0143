// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cairo.h>
#include <vtkActor.h>

#include "render/vector/placement.h"

namespace loopscope {

/// Draws what MakeActor or CellImageLayer made: points, lines and polygons in their own colours in
/// this order, or an image.
void DrawActor(vtkActor* actor, const Placement& placement, cairo_t* canvas);

/// Bytes that the marks of the actor take in a vector picture, roughly.
double VectorSizeOf(vtkActor* actor);

}  // namespace loopscope
