// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cairo.h>
#include <string>
#include <vtkActor2D.h>
#include <vtkTextProperty.h>

#include <Eigen/Core>

#include "render/vector/placement.h"

namespace loopscope {

/// Draws what MakeText or LabelsLayer made, on its plate if it has one. Anything else is left out.
void DrawTexts(vtkActor2D* actor, const Placement& placement, cairo_t* canvas);

/// One line of text in the font of `property`, which is a file, with its anchor at `anchor` of the
/// canvas. `unit` scales its size.
void DrawText(const std::string& text, vtkTextProperty* property, const Eigen::Vector2d& anchor,
              double unit, cairo_t* canvas);

}  // namespace loopscope
