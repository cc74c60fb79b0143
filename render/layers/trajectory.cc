// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/trajectory.h"

#include <cassert>

namespace loopscope {

vtkSmartPointer<vtkActor> TrajectoryLayer(const std::vector<Pose2>& poses, const Color& color,
                                          double line_width) {
  std::vector<Eigen::Vector2d> points;
  for (const Pose2& pose : poses) points.push_back(pose.translation);
  Shapes shapes;
  shapes.AddPolyline(points, color);
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

vtkSmartPointer<vtkActor> NodesLayer(const std::vector<Pose2>& poses,
                                     const std::vector<Color>& colors, double size) {
  assert(poses.size() == colors.size());
  Shapes shapes;
  for (std::size_t i = 0; i < poses.size(); ++i) shapes.AddPoint(poses[i].translation, colors[i]);
  return MakeActor(shapes.Build(), {1.0, size, true});
}

vtkSmartPointer<vtkActor> FramesLayer(const std::vector<Pose2>& target_from_frame, double length,
                                      double line_width, const Palette& palette) {
  Shapes shapes;
  for (const Pose2& frame : target_from_frame) {
    shapes.AddLine(frame.translation, frame * Eigen::Vector2d(length, 0.0), palette.axis_x);
    shapes.AddLine(frame.translation, frame * Eigen::Vector2d(0.0, length), palette.axis_y);
  }
  return MakeActor(shapes.Build(), {line_width, 1.0, false});
}

}  // namespace loopscope
