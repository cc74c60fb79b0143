// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/annotation_layer.h"

#include <algorithm>
#include <vtkStdString.h>
#include <vtkTextActor.h>
#include <vtkTextRenderer.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/view.h"
#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

using testing::Contains;
using testing::Not;

struct WrittenText {
  std::string text;
  Box box;
};

/// All texts among `props`, and where they stand.
std::vector<WrittenText> TextsOf(const Props& props) {
  std::vector<WrittenText> texts;
  for (const auto& prop : props) {
    vtkTextActor* const actor = vtkTextActor::SafeDownCast(prop);
    if (actor == nullptr) continue;
    int box[4];
    vtkTextRenderer::GetInstance()->GetBoundingBox(actor->GetTextProperty(), actor->GetInput(), box,
                                                   72);
    const double* const anchor = actor->GetPosition();
    texts.push_back({actor->GetInput(),
                     {anchor[0] + box[0], anchor[1] + box[2], double(box[1] - box[0] + 1),
                      double(box[3] - box[2] + 1)}});
  }
  return texts;
}

std::vector<std::string> Words(const std::vector<WrittenText>& texts) {
  std::vector<std::string> words;
  for (const WrittenText& text : texts) words.push_back(text.text);
  return words;
}

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

struct PictureSize {
  int width = 0;
  int height = 0;
};

class TextsOfViewTest : public testing::TestWithParam<std::tuple<ViewKind, PictureSize>> {};

TEST_P(TextsOfViewTest, NoneTouchesAnotherOrLeavesThePicture) {
  ViewRequest request;
  request.view = std::get<0>(GetParam());
  request.width = std::get<1>(GetParam()).width;
  request.height = std::get<1>(GetParam()).height;
  const Scene scene = BuildScene(SmallLoop(), request, 2);
  const std::vector<WrittenText> texts = TextsOf(scene.annotation);
  EXPECT_GT(texts.size(), 8u);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Box& box = texts[i].box;
    EXPECT_GE(box.left, 0.0) << texts[i].text;
    EXPECT_GE(box.bottom, 0.0) << texts[i].text;
    EXPECT_LE(box.right(), scene.width) << texts[i].text;
    EXPECT_LE(box.top(), scene.height) << texts[i].text;
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_FALSE(Overlap(box, texts[j].box)) << texts[i].text << " on " << texts[j].text;
    }
    for (const Panel& panel : scene.panels) {
      EXPECT_FALSE(Overlap(box, panel.frame)) << texts[i].text << " on a map";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Views, TextsOfViewTest,
    testing::Combine(testing::Values(ViewKind::kMap, ViewKind::kSubmap, ViewKind::kUpdate,
                                     ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph),
                     testing::Values(PictureSize{320, 240}, PictureSize{333, 700},
                                     PictureSize{640, 480}, PictureSize{1920, 1080},
                                     PictureSize{3840, 2160})),
    [](const auto& test_info) {
      const PictureSize size = std::get<1>(test_info.param);
      return ToString(std::get<0>(test_info.param)) + std::to_string(size.width) + "x" +
             std::to_string(size.height);
    });

Annotation SmallAnnotation() {
  Annotation annotation;
  annotation.title = "A title";
  annotation.subtitle = {"run", "step 3"};
  annotation.legend = {{{Swatch::Kind::kLine, {}, {}}, "an entry"}};
  annotation.color_bars = {
      {"a scale", {{Color{}, Color{}}}, {{0.0, "low"}, {0.01, "near low"}, {1.0, "high"}}}};
  annotation.facts = {{"name", "value"}};
  return annotation;
}

TEST(DrawAnnotationTest, WritesAllThatIsSaid) {
  const Annotation annotation = SmallAnnotation();
  const Layout layout = LayOut(MakeSheetSize(800, 600, 1), annotation, {});
  const auto words = Words(TextsOf(DrawAnnotation(annotation, layout, PaletteOf(Theme::kDefault))));
  for (const char* const text :
       {"A title", "run · step 3", "an entry", "a scale", "low", "high", "name", "value"}) {
    EXPECT_THAT(words, Contains(text));
  }
}

TEST(DrawAnnotationTest, LeavesOutATickThatWouldTouchTheOneBefore) {
  const Annotation annotation = SmallAnnotation();
  const Layout layout = LayOut(MakeSheetSize(800, 600, 1), annotation, {});
  EXPECT_THAT(Words(TextsOf(DrawAnnotation(annotation, layout, PaletteOf(Theme::kDefault)))),
              Not(Contains("near low")));
}

TEST(DrawPanelEdgeTest, WritesTheLengthOfTheScaleBarAndTheCaption) {
  const SheetSize size = MakeSheetSize(800, 600, 1);
  const PanelBoxes boxes{{10.0, 30.0, 500.0, 300.0}, {10.0, 10.0, 500.0, 18.0}};
  const FlatCamera camera{{0.0, 0.0}, 0.1};
  const Palette& palette = PaletteOf(Theme::kDefault);
  const auto texts = TextsOf(DrawPanelEdge(boxes, &camera, {"before"}, size, palette));
  EXPECT_THAT(Words(texts), testing::ElementsAre("5 m", "before"));
  EXPECT_THAT(Words(TextsOf(DrawPanelEdge(boxes, nullptr, {"before"}, size, palette))),
              testing::ElementsAre("before"));
}

}  // namespace
}  // namespace loopscope
