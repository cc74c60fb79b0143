// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/hatch.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

void AddHatch(const Extent& area, double spacing, const Color& color, Shapes* shapes) {
  // The lines are those with x - y = i * spacing * sqrt(2).
  const double step = M_SQRT2 * spacing;
  const Eigen::Vector2d min = area.min();
  const Eigen::Vector2d max = area.max();
  for (double i = std::ceil((min.x() - max.y()) / step); i * step < max.x() - min.y(); ++i) {
    const double shift = i * step;
    const double left = std::max(min.x(), min.y() + shift);
    const double right = std::min(max.x(), max.y() + shift);
    if (left < right) shapes->AddLine({left, left - shift}, {right, right - shift}, color);
  }
}

vtkSmartPointer<vtkActor> HatchLayer(const std::vector<Extent>& areas, double spacing,
                                     const Color& color, double line_width) {
  Shapes shapes;
  for (const Extent& area : areas) AddHatch(area, spacing, color, &shapes);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
