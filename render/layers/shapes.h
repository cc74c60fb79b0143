// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>
#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Core>

#include "core/geometry/pose2.h"
#include "render/palette.h"

namespace loopscope {

/// Collects flat shapes, each with its colour, into one poly data. Coordinates are those of the
/// panel that the shapes are drawn in [m], or pixels for what stands around the panels.
class Shapes {
 public:
  using Vector = Eigen::Vector2d;

  /// What is added from now on lies at z = `height`, which is 0 at first.
  void SetHeight(double height) { height_ = height; }

  void AddPoint(const Vector& point, const Color& color);
  void AddLine(const Vector& from, const Vector& to, const Color& color);
  void AddSlope(const Vector& from, double from_height, const Vector& to, double to_height,
                const Color& color);
  void AddPolyline(const std::vector<Vector>& points, const Color& color);
  void AddOutline(std::vector<Vector> corners, const Color& color);
  /// `corners` of a convex polygon, in order.
  void AddPolygon(const std::vector<Vector>& corners, const Color& color);
  void AddDisc(const Vector& center, double radius, const Color& color);
  void AddCircle(const Vector& center, double radius, const Color& color);

  bool empty() const { return points_->GetNumberOfPoints() == 0; }
  /// Its point data are the colours, RGBA.
  vtkSmartPointer<vtkPolyData> Build() const;

 private:
  vtkIdType AddVertex(const Vector& point, const Color& color);

  double height_ = 0.0;
  vtkSmartPointer<vtkPoints> points_ = vtkSmartPointer<vtkPoints>::New();
  vtkSmartPointer<vtkUnsignedCharArray> colors_ = MakeColors();
  vtkSmartPointer<vtkCellArray> vertices_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkCellArray> lines_ = vtkSmartPointer<vtkCellArray>::New();
  vtkSmartPointer<vtkCellArray> polygons_ = vtkSmartPointer<vtkCellArray>::New();

  static vtkSmartPointer<vtkUnsignedCharArray> MakeColors();
};

/// How wide lines and points are drawn [px].
struct Stroke {
  double line_width = 1.0;
  double point_size = 1.0;
  bool round_points = false;
};

/// Draws `data` in its own colours, without light. Shapes have no depth: what is added to a
/// renderer later covers what was added before.
vtkSmartPointer<vtkActor> MakeActor(vtkSmartPointer<vtkPolyData> data, const Stroke& stroke = {});

/// Likewise, but with depth: it hides what is behind it when seen from the side.
vtkSmartPointer<vtkActor> MakeSolidActor(vtkSmartPointer<vtkPolyData> data,
                                         const Stroke& stroke = {});

/// Corners of the rectangle from `min` to `max` of the source frame, counter-clockwise, in the
/// target.
std::vector<Eigen::Vector2d> RectangleCorners(const Pose2& target_from_source,
                                              const Eigen::Vector2d& min,
                                              const Eigen::Vector2d& max);

}  // namespace loopscope
