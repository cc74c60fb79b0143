// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/ground.h"

#include <cstdlib>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "render/headless/painter.h"
#include "render/layers/cell_image.h"
#include "render/layers/opacity.h"
#include "render/layers/shapes.h"

namespace loopscope {
namespace {

constexpr Color kPaper{250, 240, 230};
constexpr Color kCanvas{10, 20, 30};

/// Cells of any colour; a third of them each clear, opaque and in between.
CellImage RandomImage(const CellBox& box, Random* random) {
  CellImage image(box);
  const auto byte = [random] { return static_cast<std::uint8_t>(random->Below(256)); };
  for (int y = box.min.y; y < box.min.y + box.height; ++y) {
    for (int x = box.min.x; x < box.min.x + box.width; ++x) {
      const int kind = random->Below(3);
      const int alpha = kind == 0 ? 0 : kind == 1 ? 255 : byte();
      image.Set({x, y}, {byte(), byte(), byte(), static_cast<std::uint8_t>(alpha)});
    }
  }
  return image;
}

/// Two panels side by side that show the same.
Scene SceneOf(const Props& props, const FlatCamera& camera, int oversampling) {
  Scene scene;
  scene.width = 100 * oversampling;
  scene.height = 50 * oversampling;
  scene.oversampling = oversampling;
  scene.paper = kPaper;
  for (const double left : {5.0, 55.0}) {
    const Box frame{left * oversampling, 4.0 * oversampling, 40.0 * oversampling,
                    41.0 * oversampling};
    scene.panels.push_back({frame, camera, kCanvas, {}});
    for (const auto& prop : props) scene.panels.back().props.push_back({prop});
  }
  return scene;
}

vtkSmartPointer<vtkActor> Square(double half_side, const Color& color) {
  Shapes shapes;
  shapes.AddPolygon(RectangleCorners(Pose2(), {-half_side, -half_side}, {half_side, half_side}),
                    color);
  return MakeActor(shapes.Build());
}

vtkSmartPointer<vtkActor> ImageLayer(const Pose2& target_from_grid = Pose2()) {
  Random random(1);
  return CellImageLayer(RandomImage({{-4, -4}, 8, 8}, &random), target_from_grid, 1.0);
}

std::size_t NumLeftOf(Scene scene) {
  const Ground ground(&scene);
  return scene.panels[0].props.size();
}

TEST(Ground, IsWhatOpenGlDraws) {
  Painter painter(Backend::kOsmesa);
  Random random(2);
  for (int i = 0; i < 12; ++i) {
    const auto first = CellImageLayer(RandomImage({{-7, -5}, 17, 11}, &random), Pose2(), 1.13);
    const auto second =
        CellImageLayer(RandomImage({{0, 0}, 5, 9}, &random), Pose2({0.37, -0.21}, 0.0), 0.71);
    const FlatCamera camera{{random.Uniform(-8.0, 8.0), random.Uniform(-8.0, 8.0)},
                            random.Uniform(0.05, 1.5)};
    const int oversampling = 1 + i % 2;
    const auto marks = Square(3.0, WithOpacity({200, 0, 0}, 0.5));
    // What follows anything else is drawn by OpenGL.
    const auto nothing = Square(1.0, Color{0, 0, 0, 0});
    const Picture ours = painter.Draw(SceneOf({first, second, marks}, camera, oversampling));
    const Picture of_gl =
        painter.Draw(SceneOf({nothing, first, second, marks}, camera, oversampling));
    ASSERT_EQ(ours.rgb.size(), of_gl.rgb.size());
    int max_difference = 0;
    for (std::size_t byte = 0; byte < ours.rgb.size(); ++byte) {
      max_difference = std::max(max_difference, std::abs(ours.rgb[byte] - of_gl.rgb[byte]));
    }
    EXPECT_LE(max_difference, 2) << "scene " << i;  // of roundings
  }
}

TEST(Ground, HasPaperAndCanvasesWhereNoCellIs) {
  Scene scene = SceneOf({}, {}, 1);
  const Ground ground(&scene);
  EXPECT_EQ(scene.paper.a, 0);
  EXPECT_EQ(scene.panels[1].canvas.a, 0);
  std::vector<Color> row(100);
  ground.PaintRow(3, row.data());
  EXPECT_EQ(row, std::vector<Color>(100, kPaper));
  ground.PaintRow(4, row.data());
  EXPECT_EQ(row[4], kPaper);
  EXPECT_EQ(row[5], kCanvas);
  EXPECT_EQ(row[44], kCanvas);
  EXPECT_EQ(row[45], kPaper);
  EXPECT_EQ(row[94], kCanvas);
}

TEST(Ground, CellsAreThemselvesWhereTheyAreOpaqueAndAFifthOfBothWhereTheyAreNearlyClear) {
  const Color canvas{10, 100, 200};
  const auto pixel_of = [&](const Color& cell) {
    CellImage image({{-9, -9}, 19, 19});
    for (int y = -9; y < 10; ++y) {
      for (int x = -9; x < 10; ++x) image.Set({x, y}, cell);
    }
    Scene scene = SceneOf({CellImageLayer(image, Pose2(), 1.0)}, {{0.0, 0.0}, 0.1}, 1);
    scene.panels[0].canvas = canvas;
    const Ground ground(&scene);
    std::vector<Color> row(100);
    ground.PaintRow(20, row.data());
    return row[20];
  };
  EXPECT_EQ(pixel_of({1, 2, 3, 255}), (Color{1, 2, 3}));
  EXPECT_EQ(pixel_of({1, 2, 3, 0}), canvas);
  EXPECT_EQ(pixel_of({110, 0, 0, 51}), (Color{30, 80, 160}));
}

TEST(Ground, TellsWhichRowsAreLikeThoseBeneath) {
  Scene scene = SceneOf({ImageLayer()}, {{0.0, 0.0}, 0.3}, 2);
  const Ground ground(&scene);
  std::vector<Color> beneath(200);
  ground.PaintRow(0, beneath.data());
  int num_alike = 0;
  for (int y = 1; y < 100; ++y) {
    std::vector<Color> row(200);
    ground.PaintRow(y, row.data());
    EXPECT_EQ(ground.IsLikeRowBeneath(y), row == beneath) << "row " << y;
    num_alike += row == beneath;
    beneath = row;
  }
  // Two edges of the panels, and the nine of the eight rows of cells.
  EXPECT_EQ(num_alike, 99 - 11);
}

TEST(Ground, TakesTheImagesThatAreDrawnFirst) {
  EXPECT_EQ(NumLeftOf(SceneOf({ImageLayer(), ImageLayer()}, {}, 1)), 0u);
  EXPECT_EQ(NumLeftOf(SceneOf({ImageLayer(), Square(1.0, kPaper), ImageLayer()}, {}, 1)), 2u);
}

TEST(Ground, LeavesImagesThatLieAslantOrAreBlendedAsAWhole) {
  EXPECT_EQ(NumLeftOf(SceneOf({ImageLayer(Pose2({0.0, 0.0}, 0.1))}, {}, 1)), 1u);
  EXPECT_EQ(NumLeftOf(SceneOf({ImageLayer(Pose2({0.0, 0.0}, 0.5 * M_PI))}, {}, 1)), 1u);
  const auto half_clear = ImageLayer();
  MultiplyOpacity(0.5, half_clear);
  EXPECT_EQ(NumLeftOf(SceneOf({half_clear}, {}, 1)), 1u);
  Scene from_the_side = SceneOf({ImageLayer()}, {}, 1);
  for (Panel& panel : from_the_side.panels) panel.side = SideView{};
  EXPECT_EQ(NumLeftOf(from_the_side), 1u);
  Scene moving = SceneOf({ImageLayer()}, {}, 1);
  for (Panel& panel : moving.panels) panel.props[0].when = LayerProp::When::kMoving;
  EXPECT_EQ(NumLeftOf(moving), 1u);
}

}  // namespace
}  // namespace loopscope
