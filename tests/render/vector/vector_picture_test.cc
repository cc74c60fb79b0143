// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/vector_picture.h"

#include <vtkProperty.h>

#include <gmock/gmock.h>

#include "render/layers/cell_image.h"
#include "render/layers/labels.h"
#include "render/layers/shapes.h"
#include "render/text.h"

namespace loopscope {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr Color kRed{255, 0, 0};
constexpr Color kBlue{0, 0, 255};
constexpr TextStyle kStyle{20, Weight::kMedium, kBlue};

/// A panel of 40 x 20 pixels, its lower left corner at (20, 10) of a sheet of 80 x 60, a metre a
/// pixel, (0, 0) in its middle.
Scene SceneWith(const Props& props) {
  Scene scene;
  scene.width = 80;
  scene.height = 60;
  scene.panels.push_back({{20.0, 10.0, 40.0, 20.0}, {{0.0, 0.0}, 1.0}, kBlue, {}});
  for (const auto& prop : props) scene.panels.front().props.push_back({prop});
  return scene;
}

std::string Svg(const Scene& scene) { return EncodeVectorPicture(scene, VectorFormat::kSvg); }

vtkSmartPointer<vtkActor> Line(const Color& color, int count = 1) {
  Shapes shapes;
  for (int i = 0; i < count; ++i) shapes.AddLine({-10.0, 0.0}, {10.0, 5.0}, color);
  return MakeActor(shapes.Build(), {2.0, 1.0, false});
}

int CountOf(const std::string& part, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++count;
  }
  return count;
}

TEST(EncodeVectorPictureTest, GivesADocumentOfTheFormatAndSize) {
  EXPECT_THAT(Svg(SceneWith({})),
              HasSubstr(R"svg(width="80px" height="60px" viewBox="0 0 80 60")svg"));
  const std::string pdf = EncodeVectorPicture(SceneWith({}), VectorFormat::kPdf);
  EXPECT_THAT(pdf, StartsWith("%PDF-"));
  EXPECT_THAT(pdf, HasSubstr("/MediaBox [ 0 0 80 60 ]"));
}

TEST(EncodeVectorPictureTest, GivesTheSameBytesForTheSameScene) {
  CellImage image({{0, 0}, 2, 1});
  image.Set({0, 0}, kRed);
  const Scene scene = SceneWith({CellImageLayer(image, Pose2(), 8.0), Line(kRed)});
  for (const VectorFormat format : {VectorFormat::kSvg, VectorFormat::kPdf}) {
    EXPECT_EQ(EncodeVectorPicture(scene, format), EncodeVectorPicture(scene, format));
  }
  EXPECT_THAT(EncodeVectorPicture(scene, VectorFormat::kPdf), Not(HasSubstr("CreationDate")));
}

TEST(EncodeVectorPictureTest, PutsPointsOfAPanelWhereThePngHasThem) {
  // The middle of the panel is (40, 20) from the lower left corner, (40, 40) from the upper left.
  EXPECT_THAT(Svg(SceneWith({Line(kRed)})), HasSubstr("M 30 40 L 50 35"));
}

TEST(EncodeVectorPictureTest, LooksFromTheSideAsThePngDoes) {
  Shapes slope;
  slope.AddSlope({-10.0, 7.0}, 0.0, {10.0, 8.0}, 5.0, kRed);
  Scene scene = SceneWith({MakeActor(slope.Build())});
  scene.panels[0].side = SideView{0.0, 0.0};
  EXPECT_THAT(Svg(scene), HasSubstr("M 30 40 L 50 35"));
}

TEST(EncodeVectorPictureTest, HasTheSameLinesForAnOversampledScene) {
  Scene scene = SceneWith({Line(kRed)});
  scene.width *= 2;
  scene.height *= 2;
  scene.oversampling = 2;
  scene.panels[0].frame = {40.0, 20.0, 80.0, 40.0};
  scene.panels[0].camera.meters_per_pixel = 0.5;
  EXPECT_THAT(Svg(scene), HasSubstr("M 30 40 L 50 35"));
  EXPECT_THAT(Svg(scene), HasSubstr(R"svg(width="80px" height="60px")svg"));
  EXPECT_THAT(Svg(scene), HasSubstr("stroke-width:1;"));
}

TEST(EncodeVectorPictureTest, DrawsPropsInTheirOrderAndTextsLast) {
  Scene scene =
      SceneWith({LabelsLayer({{{0.0, 0.0}, "I"}}, kStyle, kBlue), Line(kRed), Line({0, 255, 0})});
  const std::string svg = Svg(scene);
  const std::size_t red = svg.find("stroke:rgb(100%,0%,0%)");
  const std::size_t green = svg.find("stroke:rgb(0%,100%,0%)");
  ASSERT_NE(green, std::string::npos);
  EXPECT_LT(red, green);
  EXPECT_LT(green, svg.find("<use xlink:href=\"#glyph0-1\""));
}

TEST(EncodeVectorPictureTest, KeepsClearLinesApartSoThatTheyAddUp) {
  EXPECT_EQ(CountOf("<path style=\"fill:none", Svg(SceneWith({Line(kRed, 3)}))), 1);
  const std::string clear = Svg(SceneWith({Line(WithOpacity(kRed, 0.2), 3)}));
  EXPECT_EQ(CountOf("<path style=\"fill:none", clear), 3);
  EXPECT_EQ(CountOf("stroke-opacity:0.2", clear), 3);
}

TEST(EncodeVectorPictureTest, MultipliesTheOpacityOfAnActor) {
  const auto line = Line(WithOpacity(kRed, 0.4));
  line->GetProperty()->SetOpacity(0.5);
  EXPECT_THAT(Svg(SceneWith({line})), HasSubstr("stroke-opacity:0.2;"));
}

TEST(EncodeVectorPictureTest, LeavesOutWhatIsHidden) {
  const auto line = Line(kRed);
  line->SetVisibility(false);
  EXPECT_EQ(Svg(SceneWith({line})), Svg(SceneWith({})));
}

TEST(EncodeVectorPictureTest, DrawsRoundPointsAsDots) {
  Shapes dot;
  dot.AddPoint({0.0, 0.0}, kRed);
  EXPECT_THAT(Svg(SceneWith({MakeActor(dot.Build(), {1.0, 6.0, true})})),
              HasSubstr("stroke-width:6;stroke-linecap:round"));
}

TEST(EncodeVectorPictureTest, GathersTheGridsAtTheBottomInOneImageWithoutClearParts) {
  CellImage cells({{0, 0}, 2, 1});
  const auto grid = CellImageLayer(cells, Pose2(), 8.0);
  const std::string svg = Svg(SceneWith({grid, grid, Line(kRed)}));
  EXPECT_EQ(CountOf("<image ", svg), 1);
  EXPECT_EQ(CountOf("<mask ", svg), 0);
  EXPECT_THAT(svg, HasSubstr(R"svg(width="40" height="20" xlink:href="data:image/png;base64)svg"));
  EXPECT_THAT(svg, HasSubstr(R"svg(transform="matrix(1,0,0,1,20,30)")svg"));
  EXPECT_LT(svg.find("<use xlink:href=\"#image"), svg.find("stroke:rgb(100%,0%,0%)"));
}

TEST(EncodeVectorPictureTest, KeepsTheOrderOfGridsAndMarks) {
  CellImage cells({{0, 0}, 2, 1});
  const auto grid = CellImageLayer(cells, Pose2(), 8.0);
  const std::string svg = Svg(SceneWith({grid, Line(kRed), grid}));
  EXPECT_EQ(CountOf("<image ", svg), 2);
  const std::size_t line = svg.find("stroke:rgb(100%,0%,0%)");
  EXPECT_LT(svg.find("<use xlink:href=\"#image"), line);
  EXPECT_GT(svg.rfind("<use xlink:href=\"#image"), line);
}

TEST(EncodeVectorPictureTest, MakesAnImageOfSoManyMarksThatTheFileWouldBeHuge) {
  const std::string svg = Svg(SceneWith({Line(WithOpacity(kRed, 0.2), 50000)}));
  EXPECT_LT(svg.size(), 10000u);
  EXPECT_THAT(svg, HasSubstr(R"svg(width="40" height="20" xlink:href="data:image/png;base64)svg"));
}

TEST(EncodeVectorPictureTest, CentersTextsOnTheirAnchors) {
  Scene scene = SceneWith({});
  scene.annotation = {MakeText("H", kStyle, Align::kLeft, 10.0, 20.0)};
  const std::string svg = Svg(scene);
  const std::size_t use = svg.find("<use xlink:href=\"#glyph0-1\"");
  ASSERT_NE(use, std::string::npos);
  const std::size_t y = svg.find("y=\"", use) + 3;
  EXPECT_THAT(svg.substr(use, 80), HasSubstr("x=\"10\""));
  // The anchor is at 40 from above; a capital letter is about 0.7 of the height of the font.
  EXPECT_NEAR(std::stod(svg.substr(y)), 40.0 + 0.5 * 0.7 * 20.0, 2.0);
}

}  // namespace
}  // namespace loopscope
