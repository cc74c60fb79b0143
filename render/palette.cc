// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/palette.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <stdexcept>
#include <utility>

namespace loopscope {
namespace {

constexpr Color Rgb(unsigned int hex) {
  return {static_cast<std::uint8_t>(hex >> 16), static_cast<std::uint8_t>(hex >> 8 & 0xff),
          static_cast<std::uint8_t>(hex & 0xff)};
}

std::uint8_t Mix(std::uint8_t a, std::uint8_t b, double t) {
  return static_cast<std::uint8_t>(std::lround(a + (b - a) * t));
}

/// `hue`, `saturation` and `value` in [0, 1].
Color FromHsv(double hue, double saturation, double value) {
  const auto channel = [&](double n) {
    const double k = std::fmod(n + hue * 6.0, 6.0);
    const double part = std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
    return static_cast<std::uint8_t>(std::lround(255.0 * value * (1.0 - saturation * part)));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

Palette DefaultPalette() {
  Palette p;
  p.paper = Rgb(0xffffff);
  p.ink = Rgb(0x1b1f24);
  p.faint_ink = Rgb(0x5c6570);
  p.rule = Rgb(0xb4bac1);
  p.map_free = Rgb(0xffffff);
  p.map_occupied = Rgb(0x000000);
  p.map_unknown = Rgb(0xbfc7cd);
  p.dark_free = Rgb(0x484c52);
  p.dark_occupied = Rgb(0xb9bec5);
  p.dark_unknown = Rgb(0x303336);
  p.dark_label = Rgb(0xf2f4f6);
  p.scan = Rgb(0xd93025);
  p.ray = Rgb(0x4f7fb8);
  p.hit = Rgb(0xd93025);
  p.miss = Rgb(0x74a9e6);
  p.odds = {{Rgb(0x1f5fb4), Rgb(0x86b6e8), Rgb(0xf4f4f4), Rgb(0xf19a86), Rgb(0xb51d1d)}};
  p.never_seen = Rgb(0xe3dccb);
  p.prior = Rgb(0xe8710a);
  p.correlative = Rgb(0x9334e6);
  p.refined = Rgb(0x0b8043);
  p.bound = {{Rgb(0x440154), Rgb(0x3b528b), Rgb(0x21918c), Rgb(0x5ec962), Rgb(0xfde725)}};
  p.error = {{Rgb(0x2f7fd0), Rgb(0x23a07a), Rgb(0xe0b000), Rgb(0xe8710a), Rgb(0xb51d1d)}};
  p.window = Rgb(0x1a73e8);
  p.expanded = Rgb(0x111111);
  p.hatch = WithOpacity(Rgb(0x3c444d), 0.55);
  p.winner = Rgb(0xe5178f);
  p.rival = Rgb(0x9334e6);
  p.from_behind = Rgb(0x00897b);
  p.too_low = Rgb(0x8d949c);
  p.trajectory = HueOf(0);
  p.node = Rgb(0xffffff);
  p.robot = Rgb(0xe5178f);
  p.axis_x = Rgb(0xe02020);
  p.axis_y = Rgb(0x12a012);
  p.inter = Rgb(0xffff00);
  p.inter_residual = Rgb(0x00ffff);
  p.intra_residual = Rgb(0xff2a2a);
  p.covariance = Rgb(0x8ef0a8);
  p.refused = Rgb(0xff5ac8);
  p.outlier = Rgb(0xff2fb9);
  p.selection = Rgb(0xff8a00);
  p.selection_edge = Rgb(0x15181c);
  return p;
}

/// Hues of Okabe and Ito, https://jfly.uni-koeln.de/color/.
Palette ColorBlindPalette() {
  constexpr Color kOrange = Rgb(0xe69f00);
  constexpr Color kSkyBlue = Rgb(0x56b4e9);
  constexpr Color kGreen = Rgb(0x009e73);
  constexpr Color kBlue = Rgb(0x0072b2);
  constexpr Color kVermilion = Rgb(0xd55e00);
  constexpr Color kPurple = Rgb(0xcc79a7);
  Palette p = DefaultPalette();
  p.scan = kVermilion;
  p.ray = kBlue;
  p.hit = kVermilion;
  p.miss = kSkyBlue;
  p.odds = {{kBlue, Rgb(0x9cc9ea), Rgb(0xf4f4f4), Rgb(0xf0b57a), Rgb(0xb04a00)}};
  p.error = {{Rgb(0x86b6e8), Rgb(0xe0a000), Rgb(0xb04a00), Rgb(0x3d0c02)}};
  p.prior = kOrange;
  p.correlative = kPurple;
  p.refined = kBlue;
  p.window = kBlue;
  p.winner = kGreen;
  p.rival = kPurple;
  p.from_behind = kVermilion;
  p.trajectory = kBlue;
  p.robot = kVermilion;
  p.axis_x = kVermilion;
  p.axis_y = kGreen;
  p.inter = kOrange;
  p.inter_residual = kSkyBlue;
  p.intra_residual = kGreen;
  p.covariance = Rgb(0xf0e442);
  p.outlier = kPurple;
  p.selection = Rgb(0xf0e442);
  return p;
}

/// `p` with dark paper and dark maps, for hues that are bright enough to be seen on them.
Palette OnDarkPaper(Palette p) {
  p.paper = Rgb(0x1b1d22);
  p.ink = Rgb(0xe6e9ee);
  p.faint_ink = Rgb(0x9ba4b0);
  p.rule = Rgb(0x4b525d);
  p.map_free = Rgb(0x454a53);
  p.map_occupied = Rgb(0xeef1f4);
  p.map_unknown = Rgb(0x2a2d33);
  p.odds = {{Rgb(0x5aa2f0), Rgb(0x335f92), Rgb(0x3a3d43), Rgb(0x964b3f), Rgb(0xf2685c)}};
  p.never_seen = Rgb(0x55503f);
  p.expanded = Rgb(0xf4f6f8);
  p.hatch = WithOpacity(Rgb(0xc6ced8), 0.55);
  return p;
}

Palette DarkPalette() {
  Palette p = OnDarkPaper(DefaultPalette());
  p.scan = Rgb(0xff5c4d);
  p.ray = Rgb(0x6c9fdc);
  p.hit = Rgb(0xff5c4d);
  p.prior = Rgb(0xff9838);
  p.correlative = Rgb(0xbb86fc);
  p.refined = Rgb(0x3ccf78);
  p.window = Rgb(0x62a5ff);
  p.winner = Rgb(0xff55b3);
  p.trajectory = Rgb(0x7f9bff);
  p.robot = Rgb(0xff55b3);
  p.axis_x = Rgb(0xff5151);
  p.axis_y = Rgb(0x3fce3f);
  return p;
}

Palette DarkColorBlindPalette() {
  Palette p = OnDarkPaper(ColorBlindPalette());
  p.ray = p.miss;  // the blues of light paper are lost on dark one
  p.refined = p.miss;
  p.winner = Rgb(0x34d3a4);
  p.window = p.miss;
  p.trajectory = p.miss;
  return p;
}

const std::vector<std::pair<Theme, std::string>>& Names() {
  static const std::vector<std::pair<Theme, std::string>> names{
      {Theme::kDefault, "default"},
      {Theme::kColorBlind, "color-blind"},
      {Theme::kDark, "dark"},
      {Theme::kDarkColorBlind, "dark-color-blind"}};
  return names;
}

}  // namespace

bool operator==(const Color& a, const Color& b) {
  return a.r == b.r && a.g == b.g && a.b == b.b && a.a == b.a;
}

Color WithOpacity(Color color, double share) {
  color.a = static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
  return color;
}

Color Blend(const Color& a, const Color& b, double t) {
  return {Mix(a.r, b.r, t), Mix(a.g, b.g, t), Mix(a.b, b.b, t), Mix(a.a, b.a, t)};
}

Color ColorMap::At(double t) const {
  const double place = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const std::size_t below =
      std::min<std::size_t>(static_cast<std::size_t>(place), stops.size() - 2);
  return Blend(stops[below], stops[below + 1], place - below);
}

Theme ThemeFromName(const std::string& name) {
  std::string expected;
  for (const auto& [theme, known] : Names()) {
    if (known == name) return theme;
    expected += (expected.empty() ? "" : ", ") + known;
  }
  throw std::invalid_argument("unknown theme '" + name + "': expected one of " + expected);
}

std::string ToString(Theme theme) {
  const auto found = std::find_if(Names().begin(), Names().end(),
                                  [&](const auto& entry) { return entry.first == theme; });
  return found->second;
}

std::vector<std::string> ThemeNames() {
  std::vector<std::string> names;
  for (const auto& [theme, name] : Names()) names.push_back(name);
  return names;
}

Color HueOf(int id) {
  constexpr double kGoldenRatioConjugate = 0.6180339887498949;
  constexpr double kFirstHue = 0.69;
  double whole = 0.0;
  return FromHsv(std::modf(kFirstHue + kGoldenRatioConjugate * id, &whole), 0.85, 0.77);
}

const Palette& PaletteOf(Theme theme) {
  static const std::map<Theme, Palette> palettes{{Theme::kDefault, DefaultPalette()},
                                                 {Theme::kColorBlind, ColorBlindPalette()},
                                                 {Theme::kDark, DarkPalette()},
                                                 {Theme::kDarkColorBlind, DarkColorBlindPalette()}};
  return palettes.at(theme);
}

}  // namespace loopscope
