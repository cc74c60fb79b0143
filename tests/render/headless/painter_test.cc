// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <gtest/gtest.h>

#include "render/layers/cell_image.h"
#include "render/layers/opacity.h"
#include "render/layers/shapes.h"
#include "render/text.h"

namespace loopscope {
namespace {

constexpr Color kPaper{250, 240, 230};
constexpr Color kRed{200, 0, 0};
constexpr Color kBlue{0, 0, 180};

/// A panel of 40 x 20 pixels in the middle of a sheet of 80 x 60, a metre a pixel.
Scene SceneWith(const Props& props, int oversampling = 1) {
  Scene scene;
  scene.width = 80 * oversampling;
  scene.height = 60 * oversampling;
  scene.oversampling = oversampling;
  scene.paper = kPaper;
  const double scale = oversampling;
  const Box frame{20.0 * scale, 20.0 * scale, 40.0 * scale, 20.0 * scale};
  scene.panels.push_back({frame, {{0.0, 0.0}, 1.0 / oversampling}, Color{10, 20, 30}, {}});
  for (const auto& prop : props) scene.panels[0].props.push_back({prop});
  return scene;
}

/// `x` from the left and `y` from the top.
Color PixelOf(const Picture& picture, int x, int y) {
  const std::size_t i = 3 * (static_cast<std::size_t>(y) * picture.width + x);
  return {picture.rgb[i], picture.rgb[i + 1], picture.rgb[i + 2]};
}

vtkSmartPointer<vtkActor> Rectangle(double left, double bottom, double right, double top,
                                    const Color& color) {
  Shapes shapes;
  shapes.AddPolygon(RectangleCorners(Pose2(), {left, bottom}, {right, top}), color);
  return MakeActor(shapes.Build());
}

class PainterTest : public testing::Test {
 protected:
  Painter painter_{Backend::kOsmesa};
};

TEST_F(PainterTest, FillsPaperAndPanelWithTheirExactColors) {
  const Picture picture = painter_.Draw(SceneWith({}));
  EXPECT_EQ(picture.width, 80);
  EXPECT_EQ(picture.height, 60);
  EXPECT_EQ(PixelOf(picture, 0, 0), kPaper);
  EXPECT_EQ(PixelOf(picture, 19, 30), kPaper);
  EXPECT_EQ(PixelOf(picture, 20, 30), (Color{10, 20, 30}));
  EXPECT_EQ(PixelOf(picture, 59, 39), (Color{10, 20, 30}));
  EXPECT_EQ(PixelOf(picture, 59, 40), kPaper);
}

TEST_F(PainterTest, HasXToTheRightAndYUp) {
  const Picture picture = painter_.Draw(SceneWith({Rectangle(0.0, 0.0, 20.0, 10.0, kRed)}));
  EXPECT_EQ(PixelOf(picture, 41, 28), kRed);
  EXPECT_EQ(PixelOf(picture, 39, 28), (Color{10, 20, 30}));
  EXPECT_EQ(PixelOf(picture, 41, 32), (Color{10, 20, 30}));
}

TEST_F(PainterTest, DrawsLaterPropsOverEarlierOnes) {
  const auto red = Rectangle(-10.0, -5.0, 10.0, 5.0, kRed);
  const auto blue = Rectangle(-10.0, -5.0, 10.0, 5.0, kBlue);
  EXPECT_EQ(PixelOf(painter_.Draw(SceneWith({red, blue})), 40, 30), kBlue);
  EXPECT_EQ(PixelOf(painter_.Draw(SceneWith({blue, red})), 40, 30), kRed);
}

TEST_F(PainterTest, FromTheSideWhatIsNearerHidesWhatIsDrawnLater) {
  painter_.Draw(SceneWith({Rectangle(-3.0, -3.0, 3.0, 3.0, kBlue)}));  // which needs no depth
  const auto square = [](double height, const Color& color) {
    Shapes shapes;
    shapes.SetHeight(height);
    shapes.AddPolygon(RectangleCorners(Pose2(), {-10.0, -5.0}, {10.0, 5.0}), color);
    return MakeSolidActor(shapes.Build());
  };
  Scene scene = SceneWith({square(3.0, kRed), square(0.0, kBlue)});
  scene.panels[0].side = SideView{0.0, M_PI / 4.0};
  const Picture picture = painter_.Draw(scene);
  // Red is up to 5 sin 45 + 3 cos 45 = 5.7 from the middle, blue down to 3.5 from it.
  EXPECT_EQ(PixelOf(picture, 40, 25), kRed);
  EXPECT_EQ(PixelOf(picture, 40, 29), kRed);
  EXPECT_EQ(PixelOf(picture, 40, 32), kBlue);
  EXPECT_EQ(PixelOf(picture, 40, 23), (Color{10, 20, 30}));
}

TEST_F(PainterTest, MultipliesTheOpacityOfALayerWithThatOfItsColors) {
  const auto red = Rectangle(-10.0, -5.0, 10.0, 5.0, kRed);
  const auto veil = Rectangle(-10.0, -5.0, 10.0, 5.0, WithOpacity(kBlue, 0.5));
  MultiplyOpacity(0.5, veil);
  const Color shapes = PixelOf(painter_.Draw(SceneWith({red, veil})), 40, 30);
  EXPECT_NEAR(shapes.r, 150, 2);
  EXPECT_NEAR(shapes.b, 45, 2);
  CellImage image({{-5, -5}, 10, 10});
  for (int x = -5; x < 5; ++x) {
    for (int y = -5; y < 5; ++y) image.Set({x, y}, WithOpacity(kBlue, 0.5));
  }
  const auto cells = CellImageLayer(image, Pose2(), 1.0);
  MultiplyOpacity(0.5, cells);
  const Color pixel = PixelOf(painter_.Draw(SceneWith({red, cells})), 40, 30);
  EXPECT_NEAR(pixel.r, 150, 2);
  EXPECT_NEAR(pixel.b, 45, 2);
}

TEST_F(PainterTest, BlendsHalfClearColorsOverWhatIsBeneath) {
  const auto red = Rectangle(-10.0, -5.0, 10.0, 5.0, kRed);
  const auto veil = Rectangle(-10.0, -5.0, 10.0, 5.0, WithOpacity(kBlue, 0.5));
  const Color pixel = PixelOf(painter_.Draw(SceneWith({red, veil})), 40, 30);
  EXPECT_NEAR(pixel.r, 100, 2);
  EXPECT_NEAR(pixel.b, 90, 2);
}

TEST_F(PainterTest, RoundPointsHideNothingThatIsDrawnLater) {
  Shapes dot;
  dot.AddPoint({0.0, 0.0}, kRed);
  const auto point = MakeActor(dot.Build(), {1.0, 12.0, true});
  EXPECT_EQ(PixelOf(painter_.Draw(SceneWith({point})), 40, 30), kRed);
  const auto blue = Rectangle(-10.0, -5.0, 10.0, 5.0, kBlue);
  EXPECT_EQ(PixelOf(painter_.Draw(SceneWith({point, blue})), 40, 30), kBlue);
}

TEST_F(PainterTest, DrawsCellsWithSharpEdges) {
  CellImage image({{0, 0}, 2, 1});
  image.Set({0, 0}, kRed);
  image.Set({1, 0}, kBlue);
  // Cells of 8 m: the first from -4 to 4, the second from 4 to 12.
  const Picture picture = painter_.Draw(SceneWith({CellImageLayer(image, Pose2(), 8.0)}));
  EXPECT_EQ(PixelOf(picture, 36, 30), kRed);
  EXPECT_EQ(PixelOf(picture, 43, 30), kRed);
  EXPECT_EQ(PixelOf(picture, 44, 30), kBlue);
  EXPECT_EQ(PixelOf(picture, 51, 30), kBlue);
  EXPECT_EQ(PixelOf(picture, 52, 30), (Color{10, 20, 30}));
}

TEST_F(PainterTest, OversamplingAveragesThePixelsOfAnEdge) {
  // The left edge stands in the middle of a pixel.
  const auto props = {vtkSmartPointer<vtkProp>(Rectangle(0.5, -10.0, 20.0, 10.0, kRed))};
  const Picture picture = painter_.Draw(SceneWith(props, 2));
  EXPECT_EQ(picture.width, 80);
  EXPECT_EQ(PixelOf(picture, 39, 30), (Color{10, 20, 30}));
  EXPECT_EQ(PixelOf(picture, 40, 30), (Color{105, 10, 15}));
  EXPECT_EQ(PixelOf(picture, 41, 30), kRed);
}

TEST_F(PainterTest, WritesTextInItsColor) {
  Scene scene = SceneWith({});
  scene.annotation.push_back(
      MakeText("IIII", {20, Weight::kMedium, kBlue}, Align::kLeft, 10.0, 50.0));
  const Picture picture = painter_.Draw(scene);
  int num_blue = 0;
  for (int y = 0; y < 20; ++y) {
    for (int x = 0; x < 80; ++x) num_blue += PixelOf(picture, x, y) == kBlue;
  }
  EXPECT_GT(num_blue, 40);
}

TEST_F(PainterTest, APictureDoesNotDependOnThoseDrawnBefore) {
  const auto make_scene = [] { return SceneWith({Rectangle(-10.0, -5.0, 10.0, 5.0, kRed)}, 2); };
  const Picture first = painter_.Draw(make_scene());
  painter_.Draw(SceneWith({Rectangle(-3.0, -3.0, 3.0, 3.0, kBlue)}, 1));
  EXPECT_EQ(painter_.Draw(make_scene()), first);
  EXPECT_EQ(Painter(Backend::kOsmesa).Draw(make_scene()), first);
}

TEST(BackendTest, EglAndOsmesaDrawTheSamePicture) {
  const auto make_scene = [] {
    Shapes lines;
    for (int i = 0; i < 10; ++i) lines.AddLine({-20.0, i - 5.0}, {20.0, 5.0 - 0.7 * i}, kBlue);
    return SceneWith(
        {Rectangle(-10.0, -5.0, 10.0, 5.0, kRed), MakeActor(lines.Build(), {3.0, 1.0, false})}, 2);
  };
  const Picture osmesa = Painter(Backend::kOsmesa).Draw(make_scene());
  const Picture egl = Painter(Backend::kEgl).Draw(make_scene());
  EXPECT_EQ(egl, osmesa);
}

TEST(BackendTest, UnknownNamesAreRefusedWithTheKnownOnes) {
  EXPECT_EQ(BackendFromName("auto"), Backend::kAuto);
  EXPECT_EQ(BackendFromName("osmesa"), Backend::kOsmesa);
  EXPECT_EQ(BackendFromName("egl"), Backend::kEgl);
  try {
    BackendFromName("glx");
    FAIL() << "nothing was thrown";
  } catch (const std::invalid_argument& error) {
    EXPECT_STREQ(error.what(), "unknown backend 'glx': expected auto, osmesa or egl");
  }
}

}  // namespace
}  // namespace loopscope
