// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/robot.h"

#include "render/layers/shapes.h"

namespace loopscope {

std::vector<Eigen::Vector2d> RobotOutline(const Pose2& target_from_base, double size) {
  const auto corner = [&](double ahead, double left) {
    return target_from_base * Eigen::Vector2d(ahead * size, left * size);
  };
  return {corner(0.6, 0.0), corner(-0.4, 0.42), corner(-0.4, -0.42)};
}

vtkSmartPointer<vtkActor> RobotLayer(const Pose2& target_from_base, double size, double edge_width,
                                     const Color& color) {
  constexpr Color kEdge{255, 255, 255};
  Shapes shapes;
  shapes.AddPolygon(RobotOutline(target_from_base, size + 5.0 * edge_width), kEdge);
  shapes.AddPolygon(RobotOutline(target_from_base, size), color);
  return MakeActor(shapes.Build());
}

}  // namespace loopscope
