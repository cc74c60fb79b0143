// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layout.h"

#include <stdexcept>
#include <tuple>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

Annotation FullAnnotation() {
  Annotation annotation;
  annotation.title = "Search of node (0, 1234) in submap (0, 56)";
  annotation.subtitle = {"a-log-with-a-long-name.log.gz", "step 12345 of 67890"};
  for (int i = 0; i < 8; ++i) annotation.legend.push_back({{}, "INTRA constraint, by submap"});
  annotation.color_bars = {{"probability of an obstacle", {{Color{}, Color{}}}, {}}};
  for (int i = 0; i < 12; ++i) annotation.facts.push_back({"a fact", "1234 cells"});
  return annotation;
}

std::vector<Box> AllBoxes(const Layout& layout) {
  std::vector<Box> boxes{layout.title, layout.subtitle};
  for (const std::vector<Box>* part : {&layout.legend, &layout.color_bars, &layout.facts}) {
    boxes.insert(boxes.end(), part->begin(), part->end());
  }
  for (const PanelBoxes& panel : layout.panels) {
    boxes.push_back(panel.frame);
    boxes.push_back(panel.footer);
  }
  return boxes;
}

class LayoutOfSizeTest : public testing::TestWithParam<std::tuple<int, int, int>> {
 protected:
  Layout MakeLayout() const {
    const auto [width, height, num_side_panels] = GetParam();
    Arrangement arrangement;
    arrangement.num_side_panels = num_side_panels;
    return LayOut(MakeSheetSize(width, height, 1), FullAnnotation(), arrangement);
  }
};

TEST_P(LayoutOfSizeTest, NothingOverlaps) {
  const std::vector<Box> boxes = AllBoxes(MakeLayout());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (std::size_t j = i + 1; j < boxes.size(); ++j) {
      EXPECT_FALSE(Overlap(boxes[i], boxes[j])) << i << " and " << j;
    }
  }
}

TEST_P(LayoutOfSizeTest, EverythingLiesInThePicture) {
  const Layout layout = MakeLayout();
  for (const Box& box : AllBoxes(layout)) {
    EXPECT_FALSE(box.empty());
    EXPECT_GE(box.left, 0.0);
    EXPECT_GE(box.bottom, 0.0);
    EXPECT_LE(box.right(), layout.size.width);
    EXPECT_LE(box.top(), layout.size.height);
  }
}

TEST_P(LayoutOfSizeTest, EveryPanelIsThereAndLargeEnoughToSeeSomething) {
  const Layout layout = MakeLayout();
  ASSERT_EQ(layout.panels.size(), static_cast<std::size_t>(std::get<2>(GetParam()) + 1));
  for (const PanelBoxes& panel : layout.panels) {
    EXPECT_GE(panel.frame.width, 40.0);
    EXPECT_GE(panel.frame.height, 20.0);
  }
}

TEST_P(LayoutOfSizeTest, PanelsBeginAndEndAtWholePixels) {
  for (const PanelBoxes& panel : MakeLayout().panels) {
    for (const double edge :
         {panel.frame.left, panel.frame.bottom, panel.frame.width, panel.frame.height}) {
      EXPECT_EQ(edge, std::floor(edge));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LayoutOfSizeTest,
                         testing::Values(std::tuple(320, 240, 0), std::tuple(320, 240, 2),
                                         std::tuple(320, 240, 7), std::tuple(640, 480, 2),
                                         std::tuple(480, 800, 7), std::tuple(1280, 720, 0),
                                         std::tuple(1280, 720, 7), std::tuple(1920, 1080, 2),
                                         std::tuple(2000, 400, 7), std::tuple(3840, 2160, 0),
                                         std::tuple(3840, 2160, 7)),
                         [](const auto& test) {
                           return std::to_string(std::get<0>(test.param)) + "x" +
                                  std::to_string(std::get<1>(test.param)) + "with" +
                                  std::to_string(std::get<2>(test.param));
                         });

TEST(LayoutTest, LeavesOutTheLastFactsFirst) {
  Annotation annotation = FullAnnotation();
  const Layout small = LayOut(MakeSheetSize(320, 240, 1), annotation, {});
  EXPECT_EQ(small.legend.size(), annotation.legend.size());
  EXPECT_EQ(small.color_bars.size(), 1u);
  EXPECT_GT(small.facts.size(), 0u);
  EXPECT_LT(small.facts.size(), annotation.facts.size());
  const Layout large = LayOut(MakeSheetSize(1280, 720, 1), annotation, {});
  EXPECT_EQ(large.facts.size(), annotation.facts.size());
}

TEST(LayoutTest, GivesAllTheWidthToTheMapIfNothingIsSaidBesideIt) {
  const Layout layout = LayOut(MakeSheetSize(800, 600, 1), Annotation(), {});
  EXPECT_GT(layout.panels[0].frame.width, 770.0);
}

TEST(LayoutTest, TheMainPanelIsTheLargest) {
  const Layout layout = LayOut(MakeSheetSize(1280, 720, 1), FullAnnotation(), {2});
  const auto area = [](const Box& box) { return box.width * box.height; };
  EXPECT_GT(area(layout.panels[0].frame), 2.0 * area(layout.panels[1].frame));
  EXPECT_NEAR(area(layout.panels[1].frame), area(layout.panels[2].frame), 1000.0);
}

TEST(LayoutTest, TheLastPanelMayBeAStripBeneathTheOtherSidePanels) {
  const Arrangement arrangement{2, 0.42, 2, 0.3};
  const auto panels = LayOut(MakeSheetSize(1280, 720, 1), FullAnnotation(), arrangement).panels;
  ASSERT_EQ(panels.size(), 3u);
  EXPECT_EQ(panels[1].frame.left, panels[2].frame.left);
  EXPECT_GE(panels[1].footer.bottom, panels[2].frame.top());
  EXPECT_GT(panels[1].frame.height, 2.0 * panels[2].frame.height);
}

TEST(LayoutTest, PanelsTooSmallForTheirTextKeepAPlaceToDrawIn) {
  const SheetSize size = MakeSheetSize(kMinPictureWidth, kMinPictureHeight, 1, 40);
  for (const PanelBoxes& panel : LayOut(size, FullAnnotation(), {9, 0.5, 2, 0.2}).panels) {
    EXPECT_GE(panel.frame.width, 1.0);
    EXPECT_GE(panel.frame.height, 1.0);
  }
}

TEST(SheetSizeTest, TextAndStrokesGrowWithThePicture) {
  EXPECT_EQ(MakeSheetSize(320, 240, 1).font, 8);
  EXPECT_EQ(MakeSheetSize(1280, 720, 1).font, 13);
  EXPECT_NEAR(MakeSheetSize(1280, 720, 1).unit, 1.0, 1e-9);
  EXPECT_EQ(MakeSheetSize(1920, 1080, 1).font, 18);
  EXPECT_EQ(MakeSheetSize(3840, 2160, 1).font, 32);
}

TEST(SheetSizeTest, OversamplingScalesEverything) {
  const SheetSize once = MakeSheetSize(1280, 720, 1);
  const SheetSize twice = MakeSheetSize(1280, 720, 2);
  EXPECT_EQ(twice.width, 2 * once.width);
  EXPECT_EQ(twice.height, 2 * once.height);
  EXPECT_NEAR(twice.unit, 2.0 * once.unit, 0.1);
}

TEST(SheetSizeTest, RefusesSizesThatCannotBeDrawn) {
  EXPECT_THROW(MakeSheetSize(199, 150, 1), std::invalid_argument);
  EXPECT_THROW(MakeSheetSize(200, 149, 1), std::invalid_argument);
  EXPECT_THROW(MakeSheetSize(8193, 240, 1), std::invalid_argument);
  EXPECT_EQ(MessageOf([] { MakeSheetSize(10, 10, 1); }),
            "size 10x10: expected a picture between 200x150 and 8192x8192");
}

}  // namespace
}  // namespace loopscope
