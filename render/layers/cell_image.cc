// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/cell_image.h"

#include <memory>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkTexture.h>

#include "render/layers/shapes.h"

namespace loopscope {
namespace {

static_assert(sizeof(Color) == 4, "VTK reads pixels as they are");

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

CellImage::CellImage(const CellBox& box) : CellImage(Unpainted(box)) {
  if (!box.empty()) std::uninitialized_fill_n(pixels_, box.num_cells(), Color{0, 0, 0, 0});
}

CellImage CellImage::Unpainted(const CellBox& box) {
  CellImage image;
  image.box_ = box;
  if (box.empty()) return image;
  image.image_ = vtkSmartPointer<vtkImageData>::New();
  image.image_->SetDimensions(box.width, box.height, 1);
  image.image_->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  image.pixels_ = static_cast<Color*>(image.image_->GetScalarPointer());
  return image;
}

vtkSmartPointer<vtkActor> CellImageLayer(const CellImage& image, const Pose2& target_from_grid,
                                         double resolution) {
  if (image.box().empty()) return MakeActor(Shapes().Build());
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image.vtk());
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
