// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <algorithm>
#include <cmath>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRenderStepsPass.h>
#include <vtkRendererCollection.h>

#include "render/flat_pass.h"

namespace loopscope {
namespace {

void SetBackground(const Color& color, vtkRenderer* renderer) {
  renderer->SetBackground(color.r / 255.0, color.g / 255.0, color.b / 255.0);
  renderer->SetBackgroundAlpha(color.a / 255.0);
}

void LookFrom(const SideView& side, const FlatCamera& flat, double height, vtkRenderer* renderer) {
  constexpr double kFar = 1e4;  // [m]
  const Eigen::Matrix3d map_from_view = side.ViewFromMap().transpose();
  const Eigen::Vector3d focus = map_from_view.leftCols<2>() * flat.center;
  const Eigen::Vector3d eye = focus + kFar * map_from_view.col(2);
  const Eigen::Vector3d up = map_from_view.col(1);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(eye.x(), eye.y(), eye.z());
  camera->SetFocalPoint(focus.x(), focus.y(), focus.z());
  camera->SetViewUp(up.x(), up.y(), up.z());
  camera->SetParallelScale(0.5 * height * flat.meters_per_pixel);
  renderer->ResetCameraClippingRange();
}

vtkSmartPointer<FlatPass> Flat(vtkRenderPass* pass) {
  auto flat = vtkSmartPointer<FlatPass>::New();
  flat->SetPass(pass);
  return flat;
}

vtkSmartPointer<vtkRenderer> PanelRenderer(const Panel& panel, const Scene& scene) {
  auto renderer = vtkSmartPointer<vtkRenderer>::New();
  renderer->SetViewport(panel.frame.left / scene.width, panel.frame.bottom / scene.height,
                        panel.frame.right() / scene.width, panel.frame.top() / scene.height);
  FillRenderer(panel, renderer);
  return renderer;
}

}  // namespace

Eigen::Matrix3d SideView::ViewFromMap() const {
  const Eigen::Vector3d ahead(-std::sin(azimuth), std::cos(azimuth), 0.0);
  const Eigen::Vector3d high = Eigen::Vector3d::UnitZ();
  Eigen::Matrix3d view_from_map;
  view_from_map << std::cos(azimuth), std::sin(azimuth), 0.0,
      (std::sin(elevation) * ahead + std::cos(elevation) * high).transpose(),
      (std::sin(elevation) * high - std::cos(elevation) * ahead).transpose();
  return view_from_map;
}

Extent VisibleExtent(const FlatCamera& camera, const Box& frame) {
  const Eigen::Vector2d half =
      0.5 * camera.meters_per_pixel * Eigen::Vector2d(frame.width, frame.height);
  return Extent(camera.center - half, camera.center + half);
}

FlatCamera CameraFor(const Extent& extent, const Box& frame) {
  constexpr double kMargin = 1.06;
  constexpr double kPoint = 1e-3;  // [m] what is no larger than that is a point
  if (extent.isEmpty() || extent.sizes().maxCoeff() <= kPoint) {
    Eigen::Vector2d middle = Eigen::Vector2d::Zero();
    if (!extent.isEmpty()) middle = extent.center();
    return {middle, 2.0 / std::min(frame.width, frame.height)};
  }
  const Eigen::Vector2d size = extent.sizes();
  FlatCamera camera;
  camera.center = extent.center();
  camera.meters_per_pixel = kMargin * std::max(size.x() / frame.width, size.y() / frame.height);
  return camera;
}

Panel SheetOf(const Scene& scene) {
  Panel sheet;
  sheet.frame = {0.0, 0.0, static_cast<double>(scene.width), static_cast<double>(scene.height)};
  sheet.camera = {{0.5 * scene.width, 0.5 * scene.height}, 1.0};
  sheet.canvas = scene.paper;
  for (const auto& prop : scene.annotation) sheet.props.push_back({prop});
  for (const Panel& panel : scene.panels) {
    if (!panel.edge) continue;
    for (const auto& prop : panel.edge(panel.camera)) sheet.props.push_back({prop});
  }
  return sheet;
}

void LookDown(const FlatCamera& flat, double height, vtkRenderer* renderer) {
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetPosition(flat.center.x(), flat.center.y(), 1.0);
  camera->SetFocalPoint(flat.center.x(), flat.center.y(), 0.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  camera->SetParallelScale(0.5 * height * flat.meters_per_pixel);
  camera->SetClippingRange(0.1, 2.0);
}

void PlaceCamera(const Panel& panel, vtkRenderer* renderer) {
  if (panel.side) {
    LookFrom(*panel.side, panel.camera, panel.frame.height, renderer);
  } else {
    LookDown(panel.camera, panel.frame.height, renderer);
  }
}

void SetMoving(const Panel& panel, bool moving) {
  const auto hidden = moving ? LayerProp::When::kAtRest : LayerProp::When::kMoving;
  for (const LayerProp& layer : panel.props) layer.prop->SetVisibility(layer.when != hidden);
}

void FillRenderer(const Panel& panel, vtkRenderer* renderer) {
  SetBackground(panel.canvas, renderer);
  // By default VTK averages translucent colours regardless of their order; these steps blend each
  // prop over those before it.
  vtkNew<vtkRenderStepsPass> steps;
  if (!panel.side) {
    steps->SetTranslucentPass(Flat(steps->GetTranslucentPass()));
    steps->SetOverlayPass(Flat(steps->GetOverlayPass()));
  }
  renderer->SetPass(steps);
  renderer->SetPreserveDepthBuffer(!panel.side);
  SetMoving(panel, false);
  for (const LayerProp& layer : panel.props) renderer->AddViewProp(layer.prop);
  PlaceCamera(panel, renderer);
}

void Clear(vtkRenderWindow* window) {
  while (vtkRenderer* const old = window->GetRenderers()->GetFirstRenderer()) {
    window->RemoveRenderer(old);
  }
}

void Show(const Scene& scene, vtkRenderWindow* window) {
  Clear(window);
  window->AddRenderer(PanelRenderer(SheetOf(scene), scene));
  for (const Panel& panel : scene.panels) {
    const auto renderer = PanelRenderer(panel, scene);
    renderer->SetPreserveColorBuffer(panel.canvas.a == 0);
    window->AddRenderer(renderer);
  }
}

}  // namespace loopscope
