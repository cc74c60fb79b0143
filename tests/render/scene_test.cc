// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkRendererCollection.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr Box kFrame{10.0, 20.0, 400.0, 200.0};

TEST(CameraForTest, ShowsTheWholeExtent) {
  const Extent extent(Eigen::Vector2d(-3.0, 5.0), Eigen::Vector2d(7.0, 6.0));
  const FlatCamera camera = CameraFor(extent, kFrame);
  EXPECT_TRUE(VisibleExtent(camera, kFrame).contains(extent));
  EXPECT_TRUE(camera.center.isApprox(Eigen::Vector2d(2.0, 5.5)));
}

TEST(CameraForTest, WastesNoRoomInTheTighterDirection) {
  const Extent wide(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(100.0, 1.0));
  EXPECT_NEAR(VisibleExtent(CameraFor(wide, kFrame), kFrame).sizes().x(), 106.0, 1e-9);
  const Extent tall(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(1.0, 100.0));
  EXPECT_NEAR(VisibleExtent(CameraFor(tall, kFrame), kFrame).sizes().y(), 106.0, 1e-9);
}

TEST(CameraForTest, ShowsAMetreAroundAPointAndAroundNothing) {
  const Extent point(Eigen::Vector2d(4.0, 4.0));
  EXPECT_TRUE(CameraFor(point, kFrame).center.isApprox(Eigen::Vector2d(4.0, 4.0)));
  EXPECT_NEAR(VisibleExtent(CameraFor(point, kFrame), kFrame).sizes().y(), 2.0, 1e-9);
  EXPECT_NEAR(VisibleExtent(CameraFor(Extent(), kFrame), kFrame).sizes().y(), 2.0, 1e-9);
}

TEST(FillRendererTest, LooksDownAtTheExtentOfTheCamera) {
  Panel panel;
  panel.frame = kFrame;
  panel.camera = {{3.0, -2.0}, 0.05};
  vtkNew<vtkRenderer> renderer;
  FillRenderer(panel, renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  EXPECT_TRUE(camera->GetParallelProjection());
  EXPECT_DOUBLE_EQ(camera->GetParallelScale(), 0.5 * 200.0 * 0.05);
  EXPECT_DOUBLE_EQ(camera->GetFocalPoint()[0], 3.0);
  EXPECT_DOUBLE_EQ(camera->GetFocalPoint()[1], -2.0);
  EXPECT_DOUBLE_EQ(camera->GetViewUp()[1], 1.0);
}

TEST(SideViewTest, StraightDownIsTheMapItself) {
  EXPECT_TRUE(SideView().ViewFromMap().isIdentity(1e-12));
}

TEST(SideViewTest, FromTheSideWhatIsHighIsUpAndTheNearIsTowardsTheEye) {
  const Eigen::Matrix3d from_south = SideView{0.0, 0.0}.ViewFromMap();
  EXPECT_TRUE(
      (from_south * Eigen::Vector3d(1.0, 2.0, 3.0)).isApprox(Eigen::Vector3d(1.0, 3.0, -2.0)));
  const Eigen::Matrix3d from_east = SideView{0.5 * M_PI, 0.0}.ViewFromMap();
  EXPECT_TRUE(
      (from_east * Eigen::Vector3d(1.0, 2.0, 3.0)).isApprox(Eigen::Vector3d(2.0, 3.0, 1.0)));
}

TEST(SideViewTest, IsARotation) {
  const Eigen::Matrix3d view = SideView{0.7, 0.4}.ViewFromMap();
  EXPECT_TRUE((view * view.transpose()).isIdentity(1e-12));
  EXPECT_NEAR(view.determinant(), 1.0, 1e-12);
}

TEST(PlaceCameraTest, MovesACameraThatLooksFromTheSideInItsOwnPlane) {
  Panel panel;
  panel.frame = kFrame;
  panel.side = SideView{0.0, 0.0};
  panel.camera = {{3.0, 2.0}, 0.05};
  vtkNew<vtkRenderer> renderer;
  PlaceCamera(panel, renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  EXPECT_DOUBLE_EQ(camera->GetFocalPoint()[0], 3.0);
  EXPECT_NEAR(camera->GetFocalPoint()[2], 2.0, 1e-9);
  EXPECT_LT(camera->GetPosition()[1], 0.0) << "it stands in the south";
  EXPECT_DOUBLE_EQ(camera->GetViewUp()[2], 1.0);
  EXPECT_DOUBLE_EQ(camera->GetParallelScale(), 0.5 * kFrame.height * 0.05);
}

TEST(SheetOfTest, HasThePaperAndTheAnnotationInPixels) {
  Scene scene;
  scene.width = 80;
  scene.height = 60;
  scene.paper = {1, 2, 3};
  scene.annotation.resize(2);
  const Panel sheet = SheetOf(scene);
  EXPECT_EQ(sheet.frame.width, 80.0);
  EXPECT_EQ(sheet.canvas, (Color{1, 2, 3}));
  EXPECT_EQ(sheet.props.size(), 2u);
  EXPECT_EQ(sheet.camera.center, Eigen::Vector2d(40.0, 30.0));
  EXPECT_EQ(sheet.camera.meters_per_pixel, 1.0);
}

TEST(SetMovingTest, ShowsTheStandInOnlyWhileTheCameraMoves) {
  using When = LayerProp::When;
  Panel panel;
  panel.frame = kFrame;
  for (const When when : {When::kAlways, When::kAtRest, When::kMoving}) {
    panel.props.push_back({vtkSmartPointer<vtkActor>::New(), LayerKind::kInter, when});
  }
  const auto visible = [&] {
    std::vector<int> flags;
    for (const LayerProp& layer : panel.props) flags.push_back(layer.prop->GetVisibility());
    return flags;
  };
  vtkNew<vtkRenderer> renderer;
  FillRenderer(panel, renderer);
  EXPECT_THAT(visible(), testing::ElementsAre(1, 1, 0));
  SetMoving(panel, true);
  EXPECT_THAT(visible(), testing::ElementsAre(1, 0, 1));
  SetMoving(panel, false);
  EXPECT_THAT(visible(), testing::ElementsAre(1, 1, 0));
}

TEST(ShowTest, AsksForTheEdgeOfAPanelAsItsCameraSeesIt) {
  Scene scene;
  scene.width = 500;
  scene.height = 300;
  Panel panel;
  panel.frame = kFrame;
  panel.camera = {{3.0, -2.0}, 0.05};
  std::vector<double> scales;
  vtkNew<vtkActor> edge;
  panel.edge = [&](const FlatCamera& camera) {
    scales.push_back(camera.meters_per_pixel);
    return Props{edge};
  };
  scene.panels = {panel};
  vtkNew<vtkRenderWindow> window;
  Show(scene, window);
  EXPECT_THAT(scales, testing::ElementsAre(0.05));
  EXPECT_TRUE(window->GetRenderers()->GetFirstRenderer()->HasViewProp(edge));
}

}  // namespace
}  // namespace loopscope
