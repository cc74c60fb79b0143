// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/palette.h"

#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

int Distance(const Color& a, const Color& b) {
  return std::abs(a.r - b.r) + std::abs(a.g - b.g) + std::abs(a.b - b.b);
}

/// As the eye weighs it, in [0, 255].
double Luminance(const Color& color) {
  return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b;
}

/// What is left of the distance of two colours without the difference of red and green.
double DistanceWithoutRedAndGreen(const Color& a, const Color& b) {
  const auto yellow = [](const Color& c) { return 0.5 * (c.r + c.g); };
  return std::abs(yellow(a) - yellow(b)) + std::abs(a.b - b.b);
}

TEST(PaletteTest, MapsAreWhiteWhereFreeAndBlackWhereOccupied) {
  for (const Theme theme : {Theme::kDefault, Theme::kColorBlind}) {
    EXPECT_EQ(PaletteOf(theme).map_free, (Color{255, 255, 255}));
    EXPECT_EQ(PaletteOf(theme).map_occupied, (Color{0, 0, 0}));
  }
}

TEST(PaletteTest, DefaultConstraintsHaveTheColorsOfRviz) {
  const Palette& palette = PaletteOf(Theme::kDefault);
  EXPECT_EQ(palette.inter, (Color{255, 255, 0}));
  EXPECT_EQ(palette.inter_residual, (Color{0, 255, 255}));
}

TEST(PaletteTest, NeighboringHuesAreFarApart) {
  for (int id = 0; id < 50; ++id) {
    EXPECT_GT(Distance(HueOf(id), HueOf(id + 1)), 150) << id;
    EXPECT_GT(Distance(HueOf(id), HueOf(id + 2)), 60) << id;
  }
}

TEST(PaletteTest, HueZeroIsTheBlueOfTheFirstTrajectory) {
  EXPECT_EQ(HueOf(0), (Color{53, 29, 196}));
}

TEST(PaletteTest, TheScanPosesOfTheColorBlindThemeDifferInMoreThanRedAndGreen) {
  const Palette& p = PaletteOf(Theme::kColorBlind);
  EXPECT_GT(DistanceWithoutRedAndGreen(p.prior, p.refined), 60.0);
  EXPECT_GT(DistanceWithoutRedAndGreen(p.prior, p.correlative), 60.0);
  EXPECT_GT(DistanceWithoutRedAndGreen(p.refined, p.correlative), 60.0);
  EXPECT_GT(DistanceWithoutRedAndGreen(p.hit, p.miss), 60.0);
}

TEST(PaletteTest, ASelectionStandsOutOnLightAndDarkMaps) {
  for (const Theme theme : {Theme::kDefault, Theme::kColorBlind}) {
    const Palette& p = PaletteOf(theme);
    for (const Color& color : {p.dark_free, p.dark_unknown, p.map_occupied, p.selection_edge}) {
      EXPECT_GT(Luminance(p.selection) - Luminance(color), 60.0);
    }
    for (const Color& color : {p.map_free, p.map_unknown, p.dark_occupied}) {
      EXPECT_GT(Luminance(color) - Luminance(p.selection_edge), 100.0);
    }
  }
}

TEST(PaletteTest, BoundsGetLighterAsTheyGrow) {
  for (const Theme theme : {Theme::kDefault, Theme::kColorBlind}) {
    for (int i = 0; i < 20; ++i) {
      EXPECT_LT(Luminance(PaletteOf(theme).bound.At(i / 20.0)),
                Luminance(PaletteOf(theme).bound.At((i + 1) / 20.0)));
    }
  }
}

TEST(ColorMapTest, MeetsItsStopsAndIsStraightBetweenThem) {
  const ColorMap map{{Color{0, 0, 0}, Color{100, 0, 0}, Color{100, 200, 0}}};
  EXPECT_EQ(map.At(0.0), (Color{0, 0, 0}));
  EXPECT_EQ(map.At(0.25), (Color{50, 0, 0}));
  EXPECT_EQ(map.At(0.5), (Color{100, 0, 0}));
  EXPECT_EQ(map.At(0.75), (Color{100, 100, 0}));
  EXPECT_EQ(map.At(1.0), (Color{100, 200, 0}));
}

TEST(ColorMapTest, EndsAtItsEnds) {
  const ColorMap map{{Color{10, 0, 0}, Color{20, 0, 0}}};
  EXPECT_EQ(map.At(-3.0), map.At(0.0));
  EXPECT_EQ(map.At(7.0), map.At(1.0));
}

TEST(ThemeTest, UnknownNamesAreRefusedWithTheKnownOnes) {
  EXPECT_EQ(ThemeFromName("default"), Theme::kDefault);
  EXPECT_EQ(ThemeFromName("color-blind"), Theme::kColorBlind);
  EXPECT_EQ(MessageOf([] { ThemeFromName("night"); }),
            "unknown theme 'night': expected one of default, color-blind, dark, dark-color-blind");
}

TEST(ThemeTest, NamesAreThoseOfTheThemes) {
  for (const std::string& name : ThemeNames()) EXPECT_EQ(ToString(ThemeFromName(name)), name);
}

}  // namespace
}  // namespace loopscope
