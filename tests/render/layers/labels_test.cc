// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/labels.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr TextStyle kStyle{13, Weight::kRegular, {}};
constexpr Box kFrame{0.0, 0.0, 400.0, 300.0};
const FlatCamera kCamera{{0.0, 0.0}, 0.1};  // shows 40 m x 30 m

std::vector<std::string> TextsOf(const std::vector<Label>& labels) {
  std::vector<std::string> texts;
  for (const Label& label : labels) texts.push_back(label.text);
  return texts;
}

TEST(WithoutOverlapsTest, KeepsTheFirstOfTwoThatWouldTouch) {
  const std::vector<Label> labels{
      {{0.0, 0.0}, "(0, 1)"}, {{1.0, 0.5}, "(0, 2)"}, {{0.0, 5.0}, "(0, 3)"}};
  EXPECT_EQ(TextsOf(WithoutOverlaps(labels, kCamera, kFrame, kStyle)),
            (std::vector<std::string>{"(0, 1)", "(0, 3)"}));
}

TEST(WithoutOverlapsTest, KeepsMoreInACloserView) {
  const std::vector<Label> labels{{{0.0, 0.0}, "(0, 1)"}, {{1.0, 0.5}, "(0, 2)"}};
  const FlatCamera closer{{0.0, 0.0}, 0.01};
  EXPECT_EQ(WithoutOverlaps(labels, closer, kFrame, kStyle).size(), 2u);
}

TEST(WithoutOverlapsTest, DropsWhatWouldLeaveThePanel) {
  const std::vector<Label> labels{{{19.5, 0.0}, "(0, 1)"},
                                  {{0.0, 14.9}, "(0, 2)"},
                                  {{-30.0, 0.0}, "(0, 3)"},
                                  {{-19.0, -14.0}, "(0, 4)"}};
  EXPECT_EQ(TextsOf(WithoutOverlaps(labels, kCamera, kFrame, kStyle)),
            std::vector<std::string>{"(0, 4)"});
}

TEST(MovedInsideTest, MovesALabelJustIntoThePanel) {
  for (const Eigen::Vector2d& anchor :
       {Eigen::Vector2d(19.5, 0.0), Eigen::Vector2d(0.0, 14.9), Eigen::Vector2d(-30.0, -20.0)}) {
    const Label moved = MovedInside({anchor, "(0, 1)"}, kCamera, kFrame, kStyle);
    EXPECT_EQ(moved.text, "(0, 1)");
    EXPECT_EQ(WithoutOverlaps({moved}, kCamera, kFrame, kStyle).size(), 1u) << anchor.transpose();
  }
  const Label above = MovedInside({{3.0, 14.9}, "(0, 1)"}, kCamera, kFrame, kStyle);
  EXPECT_DOUBLE_EQ(above.anchor.x(), 3.0);
  EXPECT_GT(above.anchor.y(), 10.0);
}

TEST(MovedInsideTest, LeavesALabelThatIsInThePanel) {
  const Label label = MovedInside({{1.0, -2.0}, "(0, 1)"}, kCamera, kFrame, kStyle);
  EXPECT_EQ(label.anchor, Eigen::Vector2d(1.0, -2.0));
}

}  // namespace
}  // namespace loopscope
