// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "render/palette.h"

namespace loopscope {

/// A small drawing that stands for something in a legend.
struct Swatch {
  enum class Kind { kFill, kHatch, kOutline, kLine, kPoint, kFrame, kRobot };

  Kind kind = Kind::kFill;
  Color color;
  Color backing;  ///< of the patch beneath, so that it is seen as in the map
};

struct LegendEntry {
  Swatch swatch;
  std::string label;
};

/// A number and what it is, such as "score" and "0.612".
struct Fact {
  std::string name;
  std::string value;
};

struct ColorBar {
  struct Tick {
    double place = 0.0;  ///< along the bar, in [0, 1]
    std::string label;
  };

  std::string title;  ///< what the colours measure, with its unit
  ColorMap colors;
  std::vector<Tick> ticks;  ///< the most important first
};

/// All that is said around the maps of a picture.
struct Annotation {
  std::string title;
  std::vector<std::string> subtitle;  ///< run, step, ids: the most important first
  std::vector<LegendEntry> legend;
  std::vector<ColorBar> color_bars;
  std::vector<Fact> facts;  ///< the most important first
};

}  // namespace loopscope
