// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/cell.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/simulation/random.h"
#include "tests/support/ascii_grid.h"

namespace loopscope {
namespace {

void ExpectBox(const CellBox& box, CellIndex min, int width, int height) {
  EXPECT_EQ(box.min, min);
  EXPECT_EQ(box.width, width);
  EXPECT_EQ(box.height, height);
}

TEST(CellOf, IsTheNearestGridPoint) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Eigen::Vector2d point{random.Uniform(-9.0, 9.0), random.Uniform(-9.0, 9.0)};
    const Eigen::Vector2d offset = point - CenterOf(CellOf(point, 0.05), 0.05);
    EXPECT_LE(offset.cwiseAbs().maxCoeff(), 0.025 + 1e-12);
  }
}

TEST(CellOf, CountsTheLowerEdgesOfAPixelToIt) {
  EXPECT_EQ(CellOf({0.25, -0.25}, 0.5), (CellIndex{1, 0}));
  EXPECT_EQ(CellOf({-0.75, 0.75}, 0.5), (CellIndex{-1, 2}));
}

TEST(CellBox, ContainsItsLowerBorderButNotItsUpper) {
  const CellBox box{{-3, 5}, 2, 4};
  EXPECT_TRUE(box.Contains({-3, 5}));
  EXPECT_TRUE(box.Contains({-2, 8}));
  EXPECT_FALSE(box.Contains({-4, 5}));
  EXPECT_FALSE(box.Contains({-1, 5}));
  EXPECT_FALSE(box.Contains({-3, 4}));
  EXPECT_FALSE(box.Contains({-3, 9}));
}

TEST(CellBox, CountsItsCellsRowByRow) {
  const CellBox box{{-3, 5}, 2, 4};
  int expected = 0;
  for (int y = 5; y < 9; ++y) {
    for (int x = -3; x < -1; ++x) EXPECT_EQ(box.FlatIndex({x, y}), expected++);
  }
  EXPECT_EQ(box.num_cells(), expected);
}

TEST(CellBox, IsEmptyWithoutWidthOrHeight) {
  EXPECT_TRUE(CellBox().empty());
  EXPECT_TRUE((CellBox{{1, 1}, 0, 3}).empty());
  EXPECT_TRUE((CellBox{{1, 1}, 3, 0}).empty());
  EXPECT_FALSE((CellBox{{1, 1}, 1, 1}).empty());
}

TEST(Union, HoldsBothBoxesAndNoMore) {
  ExpectBox(Union({{0, 0}, 2, 2}, {{5, -3}, 1, 1}), {0, -3}, 6, 5);
  ExpectBox(Union({{5, -3}, 1, 1}, {{0, 0}, 2, 2}), {0, -3}, 6, 5);
  ExpectBox(Union({{0, 0}, 9, 9}, {{2, 3}, 1, 1}), {0, 0}, 9, 9);
}

TEST(Union, TakesNoCornerFromAnEmptyBox) {
  ExpectBox(Union({{50, 50}, 0, 0}, {{2, 3}, 4, 5}), {2, 3}, 4, 5);
  ExpectBox(Union({{2, 3}, 4, 5}, {{50, 50}, 7, 0}), {2, 3}, 4, 5);
}

TEST(Intersection, HoldsTheCellsOfBothBoxes) {
  ExpectBox(Intersection({{0, 0}, 4, 5}, {{2, -3}, 9, 6}), {2, 0}, 2, 3);
  ExpectBox(Intersection({{0, 0}, 9, 9}, {{2, 3}, 1, 1}), {2, 3}, 1, 1);
  EXPECT_TRUE(Intersection({{0, 0}, 4, 5}, {{4, 0}, 3, 3}).empty());
  EXPECT_TRUE(Intersection({{0, 0}, 4, 5}, {{0, -7}, 3, 3}).empty());
}

TEST(Intersection, IsNeverInsideOut) {
  EXPECT_TRUE(Intersection({{0, 0}, 2, 2}, {{5, 9}, 3, 3}) == CellBox());
  EXPECT_TRUE(Intersection({{0, 0}, 2, 2}, {{5, 1}, 3, 3}) == CellBox());
}

TEST(BoxOf, HoldsTheCellsAndNoMore) {
  ExpectBox(BoxOf({{4, -2}, {-1, 7}, {0, 0}}), {-1, -2}, 6, 10);
  ExpectBox(BoxOf({{4, -2}}), {4, -2}, 1, 1);
}

TEST(BoxOf, HoldsTheCellsOfAnExtent) {
  ExpectBox(BoxOf({Eigen::Vector2d(-0.12, 0.02), Eigen::Vector2d(0.13, 0.03)}, 0.05), {-2, 0}, 6,
            2);
  EXPECT_TRUE(BoxOf(Eigen::AlignedBox2d(), 0.05).empty());
}

TEST(BoxOf, RefusesPlacesWhoseIndexIsNoInt) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  for (const double far : {1e9, -1e300, kNan}) {
    EXPECT_THROW(BoxOf(Eigen::AlignedBox2d(Eigen::Vector2d(0.0, far)), 0.05), std::length_error);
  }
}

TEST(BoxOf, OfNoCellsIsEmpty) { EXPECT_TRUE(BoxOf({}).empty()); }

}  // namespace
}  // namespace loopscope
