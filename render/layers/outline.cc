// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/outline.h"

#include "render/layers/shapes.h"

namespace loopscope {

vtkSmartPointer<vtkActor> OutlineLayer(const Extent& extent, const Color& color,
                                       double line_width) {
  Shapes shapes;
  shapes.AddOutline(RectangleCorners(Pose2(), extent.min(), extent.max()), color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> CircleLayer(const Eigen::Vector2d& center, double radius,
                                      const Color& color, double line_width) {
  Shapes shapes;
  shapes.AddCircle(center, radius, color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
