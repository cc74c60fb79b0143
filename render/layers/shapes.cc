// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/shapes.h"

#include <cmath>
#include <vtkPointData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>

namespace loopscope {
namespace {

std::vector<Eigen::Vector2d> CircleCorners(const Eigen::Vector2d& center, double radius) {
  constexpr int kCorners = 24;
  std::vector<Eigen::Vector2d> corners;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2.0 * M_PI * i / kCorners;
    corners.push_back(center + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

}  // namespace

vtkSmartPointer<vtkUnsignedCharArray> Shapes::MakeColors() {
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetName("color");
  colors->SetNumberOfComponents(4);
  return colors;
}

vtkIdType Shapes::AddVertex(const Vector& point, const Color& color) {
  colors_->InsertNextTuple4(color.r, color.g, color.b, color.a);
  return points_->InsertNextPoint(point.x(), point.y(), height_);
}

void Shapes::AddPoint(const Vector& point, const Color& color) {
  const vtkIdType vertex = AddVertex(point, color);
  vertices_->InsertNextCell(1, &vertex);
}

void Shapes::AddLine(const Vector& from, const Vector& to, const Color& color) {
  const vtkIdType ends[2] = {AddVertex(from, color), AddVertex(to, color)};
  lines_->InsertNextCell(2, ends);
}

void Shapes::AddSlope(const Vector& from, double from_height, const Vector& to, double to_height,
                      const Color& color) {
  const double height = height_;
  SetHeight(from_height);
  const vtkIdType first = AddVertex(from, color);
  SetHeight(to_height);
  const vtkIdType ends[2] = {first, AddVertex(to, color)};
  SetHeight(height);
  lines_->InsertNextCell(2, ends);
}

void Shapes::AddPolyline(const std::vector<Vector>& points, const Color& color) {
  if (points.size() < 2) return;
  lines_->InsertNextCell(static_cast<int>(points.size()));
  for (const Vector& point : points) lines_->InsertCellPoint(AddVertex(point, color));
}

void Shapes::AddOutline(std::vector<Vector> corners, const Color& color) {
  if (!corners.empty()) corners.push_back(corners.front());
  AddPolyline(corners, color);
}

void Shapes::AddPolygon(const std::vector<Vector>& corners, const Color& color) {
  polygons_->InsertNextCell(static_cast<int>(corners.size()));
  for (const Vector& corner : corners) polygons_->InsertCellPoint(AddVertex(corner, color));
}

void Shapes::AddDisc(const Vector& center, double radius, const Color& color) {
  AddPolygon(CircleCorners(center, radius), color);
}

void Shapes::AddCircle(const Vector& center, double radius, const Color& color) {
  AddOutline(CircleCorners(center, radius), color);
}

vtkSmartPointer<vtkPolyData> Shapes::Build() const {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points_);
  data->SetVerts(vertices_);
  data->SetLines(lines_);
  data->SetPolys(polygons_);
  data->GetPointData()->SetScalars(colors_);
  return data;
}

vtkSmartPointer<vtkActor> MakeActor(vtkSmartPointer<vtkPolyData> data, const Stroke& stroke) {
  auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->LightingOff();
  actor->GetProperty()->SetLineWidth(static_cast<float>(stroke.line_width));
  actor->GetProperty()->SetPointSize(static_cast<float>(stroke.point_size));
  actor->GetProperty()->SetRenderPointsAsSpheres(stroke.round_points);
  // Translucent actors are drawn in the order in which they were added, and hide nothing after
  // them.
  actor->ForceTranslucentOn();
  return actor;
}

vtkSmartPointer<vtkActor> MakeSolidActor(vtkSmartPointer<vtkPolyData> data, const Stroke& stroke) {
  const auto actor = MakeActor(data, stroke);
  actor->ForceTranslucentOff();
  actor->ForceOpaqueOn();
  return actor;
}

std::vector<Eigen::Vector2d> RectangleCorners(const Pose2& target_from_source,
                                              const Eigen::Vector2d& min,
                                              const Eigen::Vector2d& max) {
  return {target_from_source * min, target_from_source * Eigen::Vector2d(max.x(), min.y()),
          target_from_source * max, target_from_source * Eigen::Vector2d(min.x(), max.y())};
}

}  // namespace loopscope
