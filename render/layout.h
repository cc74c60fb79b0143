// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "render/annotation.h"
#include "render/box.h"
#include "render/text.h"

namespace loopscope {

constexpr int kMinPictureWidth = 200;   ///< [px]
constexpr int kMinPictureHeight = 150;  ///< [px]
constexpr int kMaxPictureSide = 8192;   ///< [px]

/// Pixels of a picture and how large its text and strokes are.
struct SheetSize {
  int width = 0;      ///< [px]
  int height = 0;     ///< [px]
  int font = 0;       ///< height of the text [px]
  double unit = 0.0;  ///< [px] of which the text is 13 high; strokes are given in it
};

/// The size of a picture of width x height that is drawn with `oversampling` times as many pixels
/// in each direction. Text is `text_height` high [px], or as fits the picture. Throws
/// std::invalid_argument unless it is between the limits of a picture.
SheetSize MakeSheetSize(int width, int height, int oversampling,
                        std::optional<int> text_height = std::nullopt);

/// Where a map stands and the strip with its scale bar and caption beneath.
struct PanelBoxes {
  Box frame;
  Box footer;
};

/// Where everything of a picture stands. No two boxes overlap, and all lie inside of the picture.
/// Entries of the annotation that find no room have no box: facts go first, the last of them before
/// the others, then colour bars, then entries of the legend.
struct Layout {
  SheetSize size;
  Box title;
  Box subtitle;
  std::vector<Box> legend;
  std::vector<Box> color_bars;
  std::vector<Box> facts;
  /// The main panel, and then as many as were asked for beside it.
  std::vector<PanelBoxes> panels;
};

/// How the maps share the room that the annotation leaves.
struct Arrangement {
  int num_side_panels = 0;
  double main_share = 0.6;  ///< of the main panel, if there are others
  int footer_rows = 1;      ///< 2: the captions stand in a row of their own beneath the scale bars
  double last_share = 0.0;  ///< of the last panel, beneath the other side panels; 0: like them
};

Layout LayOut(const SheetSize& size, const Annotation& annotation, const Arrangement& arrangement);

// How the parts are written: layout and drawing have to agree on it.
TextStyle TitleStyle(const SheetSize& size, const Palette& palette);
TextStyle TextStyleOf(const SheetSize& size, const Color& color);
constexpr double kSwatchWidth = 1.9;  ///< in heights of the text, with the gap behind it
constexpr double kFactGap = 1.0;      ///< between name and number, likewise

}  // namespace loopscope
