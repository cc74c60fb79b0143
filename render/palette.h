// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace loopscope {

struct Color {
  std::uint8_t r = 0;
  std::uint8_t g = 0;
  std::uint8_t b = 0;
  std::uint8_t a = 255;  ///< 0 is clear, 255 opaque
};

bool operator==(const Color& a, const Color& b);
inline bool operator!=(const Color& a, const Color& b) { return !(a == b); }

/// The same colour, covering only `share` in [0, 1] of what is beneath.
Color WithOpacity(Color color, double share);

/// The colour a share `t` in [0, 1] of the way from `a` to `b`.
Color Blend(const Color& a, const Color& b, double t);

/// A scale of colours over [0, 1]: even steps between stops, straight lines in RGB between them.
struct ColorMap {
  std::vector<Color> stops;

  /// `t` is clamped to [0, 1].
  Color At(double t) const;
};

enum class Theme {
  kDefault,         ///< Cartographer's RViz convention
  kColorBlind,      ///< hues told apart with any colour vision (Okabe and Ito)
  kDark,            ///< the default on dark paper, free space dark and obstacles bright
  kDarkColorBlind,  ///< likewise with the hues of kColorBlind
};

/// "default", "color-blind", "dark" or "dark-color-blind". Throws std::invalid_argument naming
/// these for anything else.
Theme ThemeFromName(const std::string& name);
std::string ToString(Theme theme);

/// The names of all themes.
std::vector<std::string> ThemeNames();

/// Colour `id` of an endless series of hues, any two near ids far apart: steps of the golden ratio,
/// as Cartographer colours trajectories.
Color HueOf(int id);

/// Every colour of a picture by its meaning.
struct Palette {
  // Paper: what stands around the maps.
  Color paper;
  Color ink;        ///< titles and numbers
  Color faint_ink;  ///< names of numbers, captions
  Color rule;       ///< frames of panels

  // Maps.
  Color map_free;
  Color map_occupied;
  Color map_unknown;
  Color dark_free;  ///< the same three for maps that only stand behind a graph
  Color dark_occupied;
  Color dark_unknown;
  Color dark_label;  ///< text on these

  // One scan.
  Color scan;
  Color ray;
  Color hit;
  Color miss;
  ColorMap odds;      ///< from certainly free to certainly occupied
  Color never_seen;   ///< a cell without odds
  Color prior;        ///< the scan where it was predicted,
  Color correlative;  ///< where the correlative matcher put it,
  Color refined;      ///< and where (CS) put it

  // Loop search.
  ColorMap bound;  ///< from low to high scores
  Color window;
  Color expanded;
  Color hatch;  ///< of pruned blocks
  Color winner;
  Color rival;        ///< another place where the scan fits as well
  Color from_behind;  ///< returns on walls that the submap knows from the other side only
  Color too_low;      ///< the score of a search that found nothing

  // Graph.
  Color trajectory;
  Color node;
  Color robot;
  Color axis_x;
  Color axis_y;
  Color inter;
  Color inter_residual;
  Color intra_residual;
  Color covariance;
  Color refused;         ///< a loop that was found and not believed
  Color outlier;         ///< a loop that was closed and is left out by the optimization
  ColorMap error;        ///< from right to wrong, seen on light maps
  Color selection;       ///< what the user looks at, seen on light and dark maps
  Color selection_edge;  ///< around its lines
};

const Palette& PaletteOf(Theme theme);

/// Widths of lines and sizes of marks, in units of which the text is 13 high: a picture's unit
/// grows with it.
namespace widths {
constexpr double kHairline = 0.7;
constexpr double kThin = 1.1;
constexpr double kLine = 1.7;
constexpr double kBold = 2.6;
constexpr double kScanPoint = 2.6;
constexpr double kNode = 2.8;
constexpr double kMark = 9.0;
constexpr double kHatch = 4.5;  ///< between the lines of a hatch
constexpr double kAxis = 16.0;  ///< length of the axes of a frame
}  // namespace widths

}  // namespace loopscope
