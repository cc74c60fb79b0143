// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/scan.h"

#include "render/layers/shapes.h"

namespace loopscope {

vtkSmartPointer<vtkActor> ScanLayer(const PointCloud& points_in_scan, const Pose2& target_from_scan,
                                    const Color& color, double size) {
  Shapes shapes;
  for (const Eigen::Vector2d& point : points_in_scan) {
    shapes.AddPoint(target_from_scan * point, color);
  }
  return MakeActor(shapes.Build(), {1.0, size, true});
}

vtkSmartPointer<vtkActor> MovesLayer(const PointCloud& points_in_scan,
                                     const Pose2& target_from_first,
                                     const Pose2& target_from_second, const Color& color,
                                     double line_width) {
  Shapes shapes;
  for (const Eigen::Vector2d& point : points_in_scan) {
    shapes.AddLine(target_from_first * point, target_from_second * point, color);
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> RaysLayer(const RangeData& data, const Color& color, double width) {
  Shapes shapes;
  for (const PointCloud* ends : {&data.returns, &data.misses}) {
    for (const Eigen::Vector2d& end : *ends) shapes.AddLine(data.origin, end, color);
  }
  return MakeActor(shapes.Build(), {width, 1.0, false});
}

}  // namespace loopscope
