// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layout.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

namespace loopscope {
namespace {

// In heights of the text.
constexpr double kMargin = 0.8;
constexpr double kRow = 1.45;
constexpr double kColorBarHeight = 3.9;  // title, bar, ticks
constexpr double kSectionGap = 0.8;
constexpr double kMinColorBarWidth = 11.0;

constexpr double kMaxColumnShare = 0.36;  // of the width of the picture

double WidestRow(const SheetSize& size, const Annotation& annotation) {
  const TextStyle style = TextStyleOf(size, {});
  double widest = annotation.color_bars.empty() ? 0.0 : kMinColorBarWidth * size.font;
  for (const LegendEntry& entry : annotation.legend) {
    widest = std::max(widest, kSwatchWidth * size.font + TextWidth(entry.label, style));
  }
  for (const ColorBar& bar : annotation.color_bars) {
    widest = std::max(widest, TextWidth(bar.title, style));
  }
  for (const Fact& fact : annotation.facts) {
    widest = std::max(
        widest, TextWidth(fact.name, style) + kFactGap * size.font + TextWidth(fact.value, style));
  }
  return widest;
}

/// Cuts up to `count` boxes off the top of `column`, as many as fit whole.
std::vector<Box> CutSection(std::size_t count, double height, double gap, Box* column) {
  std::vector<Box> boxes;
  while (boxes.size() < count && column->height >= height) boxes.push_back(CutTop(height, column));
  if (!boxes.empty()) CutTop(gap, column);
  return boxes;
}

/// The columns of a grid for `count` panels in a box of this shape that makes the panels largest.
int BestNumColumns(int count, double width, double height) {
  int best = 1;
  double best_size = 0.0;
  for (int columns = 1; columns <= count; ++columns) {
    const int rows = (count + columns - 1) / columns;
    const double size = std::min(width / columns, height / rows);
    if (size > best_size) {
      best = columns;
      best_size = size;
    }
  }
  return best;
}

std::vector<Box> GridCells(int count, const Box& area, double gap) {
  const int columns = BestNumColumns(count, area.width, area.height);
  const int rows = (count + columns - 1) / columns;
  const double width = (area.width - gap * (columns - 1)) / columns;
  const double height = (area.height - gap * (rows - 1)) / rows;
  std::vector<Box> cells;
  for (int i = 0; i < count; ++i) {
    const int row = i / columns;
    cells.push_back({area.left + (i % columns) * (width + gap),
                     area.top() - (row + 1) * height - row * gap, width, height});
  }
  return cells;
}

std::vector<Box> SideBoxes(const Arrangement& arrangement, Box area, double gap) {
  if (arrangement.last_share <= 0.0) return GridCells(arrangement.num_side_panels, area, gap);
  const Box last = CutBottom(arrangement.last_share * area.height, &area);
  CutBottom(gap, &area);
  std::vector<Box> boxes = GridCells(arrangement.num_side_panels - 1, area, gap);
  boxes.push_back(last);
  return boxes;
}

/// Whole pixels, so that an image in the panel can be drawn pixel by pixel; one at least, so that
/// whatever is drawn in it has a scale.
Box Rounded(const Box& box) {
  const double left = std::ceil(box.left);
  const double bottom = std::ceil(box.bottom);
  return {left, bottom, std::max(1.0, std::floor(box.right()) - left),
          std::max(1.0, std::floor(box.top()) - bottom)};
}

std::vector<PanelBoxes> PlacePanels(const SheetSize& size, const Arrangement& arrangement,
                                    Box area) {
  std::vector<Box> boxes;
  if (arrangement.num_side_panels == 0) {
    boxes.push_back(area);
  } else {
    const double gap = kMargin * size.font;
    const bool side_by_side = area.width >= area.height;
    boxes.push_back(side_by_side ? CutLeft(arrangement.main_share * area.width, &area)
                                 : CutTop(arrangement.main_share * area.height, &area));
    side_by_side ? CutLeft(gap, &area) : CutTop(gap, &area);
    for (const Box& cell : SideBoxes(arrangement, area, gap)) boxes.push_back(cell);
  }
  std::vector<PanelBoxes> panels;
  for (Box& box : boxes) {
    constexpr double kMaxFooterShare = 0.5;  // of a panel that is too small for its text
    const Box footer = CutBottom(
        std::min(arrangement.footer_rows * kRow * size.font, kMaxFooterShare * box.height), &box);
    panels.push_back({Rounded(box), Rounded(footer)});
  }
  return panels;
}

/// Takes the column with everything that is said beside the maps off the right of `area`.
void PlaceColumn(const Annotation& annotation, Box* area, Layout* layout) {
  const SheetSize& size = layout->size;
  const double width =
      std::ceil(std::min(WidestRow(size, annotation), kMaxColumnShare * size.width));
  if (width <= 0.0) return;
  Box column = CutRight(width, area);
  CutRight(kMargin * size.font, area);
  const double gap = kSectionGap * size.font;
  layout->legend = CutSection(annotation.legend.size(), kRow * size.font, gap, &column);
  layout->color_bars =
      CutSection(annotation.color_bars.size(), kColorBarHeight * size.font, gap, &column);
  layout->facts = CutSection(annotation.facts.size(), kRow * size.font, gap, &column);
}

}  // namespace

SheetSize MakeSheetSize(int width, int height, int oversampling, std::optional<int> text_height) {
  if (width < kMinPictureWidth || height < kMinPictureHeight || width > kMaxPictureSide ||
      height > kMaxPictureSide) {
    throw std::invalid_argument(
        fmt::format("size {}x{}: expected a picture between {}x{} and {}x{}", width, height,
                    kMinPictureWidth, kMinPictureHeight, kMaxPictureSide, kMaxPictureSide));
  }
  const double shorter = std::min<double>(height, 0.75 * width);
  const double fitting = std::max(8.0, 3.2 + 0.0135 * shorter);
  const double font = text_height ? *text_height : fitting;
  SheetSize size;
  size.width = width * oversampling;
  size.height = height * oversampling;
  size.font = static_cast<int>(std::lround(font * oversampling));
  size.unit = size.font / 13.0;
  return size;
}

TextStyle TitleStyle(const SheetSize& size, const Palette& palette) {
  return {static_cast<int>(std::lround(1.35 * size.font)), Weight::kMedium, palette.ink};
}

TextStyle TextStyleOf(const SheetSize& size, const Color& color) {
  return {size.font, Weight::kRegular, color};
}

Layout LayOut(const SheetSize& size, const Annotation& annotation, const Arrangement& arrangement) {
  Layout layout;
  layout.size = size;
  Box area = Shrunk({0.0, 0.0, static_cast<double>(size.width), static_cast<double>(size.height)},
                    kMargin * size.font);
  layout.title = CutTop(1.6 * size.font, &area);
  if (!annotation.subtitle.empty()) layout.subtitle = CutTop(kRow * size.font, &area);
  CutTop(0.4 * size.font, &area);
  PlaceColumn(annotation, &area, &layout);
  layout.panels = PlacePanels(size, arrangement, area);
  return layout;
}

}  // namespace loopscope
