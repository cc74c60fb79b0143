// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/cell_image.h"

#include <cstring>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTexture.h>

#include "render/layers/shapes.h"

namespace loopscope {
namespace {

static_assert(sizeof(Color) == 4, "pixels are copied as they are");

/// The pixels of `box`, which end half a cell beyond its grid points.
vtkSmartPointer<vtkPolyData> TexturedRectangle(const CellBox& box, const Pose2& target_from_grid,
                                               double resolution) {
  const Eigen::Vector2d half(0.5 * resolution, 0.5 * resolution);
  const CellIndex last{box.min.x + box.width - 1, box.min.y + box.height - 1};
  Shapes shapes;
  shapes.AddPolygon(RectangleCorners(target_from_grid, CenterOf(box.min, resolution) - half,
                                     CenterOf(last, resolution) + half),
                    Color{255, 255, 255});
  vtkNew<vtkFloatArray> texture_coordinates;
  texture_coordinates->SetNumberOfComponents(2);
  for (const auto& [u, v] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) {
    texture_coordinates->InsertNextTuple2(u, v);
  }
  const vtkSmartPointer<vtkPolyData> data = shapes.Build();
  data->GetPointData()->SetTCoords(texture_coordinates);
  return data;
}

}  // namespace

CellImage::CellImage(const CellBox& box) : box_(box) {
  if (!box.empty()) pixels_.assign(box.num_cells(), Color{0, 0, 0, 0});
}

vtkSmartPointer<vtkImageData> CellImage::ToVtk() const {
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(box_.width, box_.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::memcpy(image->GetScalarPointer(), pixels_.data(), pixels_.size() * sizeof(Color));
  return image;
}

vtkSmartPointer<vtkActor> CellImageLayer(const CellImage& image, const Pose2& target_from_grid,
                                         double resolution) {
  if (image.box().empty()) return MakeActor(Shapes().Build());
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image.ToVtk());
  texture->InterpolateOff();
  texture->MipmapOff();
  texture->RepeatOff();
  texture->EdgeClampOn();
  texture->SetColorModeToDirectScalars();
  const auto actor = MakeActor(TexturedRectangle(image.box(), target_from_grid, resolution));
  actor->SetTexture(texture);
  return actor;
}

}  // namespace loopscope
