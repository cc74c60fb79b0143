// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/annotation_layer.h"

#include <algorithm>

#include "render/layers/hatch.h"
#include "render/layers/robot.h"
#include "render/layers/shapes.h"
#include "render/scale_bar.h"

namespace loopscope {
namespace {

using Vector = Eigen::Vector2d;

std::vector<Vector> Corners(const Box& box) {
  return RectangleCorners(Pose2(), {box.left, box.bottom}, {box.right(), box.top()});
}

/// Draws what a picture says around its maps, in pixels.
class AnnotationPen {
 public:
  AnnotationPen(const SheetSize& size, const Palette& palette) : size_(size), palette_(palette) {}

  void Write(const std::string& text, const TextStyle& style, Align align, double x, double y) {
    if (!text.empty()) texts_.push_back(MakeText(text, style, align, x, y));
  }
  void DrawSwatch(const Swatch& swatch, const Box& box);
  void DrawLegendEntry(const LegendEntry& entry, const Box& box);
  void DrawColorBar(const ColorBar& bar, Box box);
  void DrawFact(const Fact& fact, const Box& box);
  void DrawOutline(const Box& box) { thin_.AddOutline(Corners(box), palette_.rule); }
  /// Returns the width that it took.
  double DrawScaleBar(const FlatCamera& camera, const Box& box);

  Props Finish() const {
    Props props{
        MakeActor(fills_.Build()),
        MakeActor(thin_.Build(), {widths::kThin * size_.unit, 1.0, false}),
        MakeActor(bold_.Build(), {widths::kBold * size_.unit, widths::kMark * size_.unit, true})};
    props.insert(props.end(), texts_.begin(), texts_.end());
    return props;
  }

  TextStyle Ink() const { return TextStyleOf(size_, palette_.ink); }
  TextStyle FaintInk() const { return TextStyleOf(size_, palette_.faint_ink); }

 private:
  void DrawTicks(const std::vector<ColorBar::Tick>& ticks, const Box& colors, const Box& labels);

  const SheetSize& size_;
  const Palette& palette_;
  Shapes fills_;
  Shapes thin_;
  Shapes bold_;
  Props texts_;
};

void AnnotationPen::DrawSwatch(const Swatch& swatch, const Box& box) {
  const Vector center(box.center_x(), box.center_y());
  fills_.AddPolygon(Corners(box), swatch.backing);
  const double radius = 0.5 * widths::kMark * size_.unit;
  switch (swatch.kind) {
    case Swatch::Kind::kFill:
      fills_.AddPolygon(Corners(box), swatch.color);
      thin_.AddOutline(Corners(box), palette_.rule);
      break;
    case Swatch::Kind::kHatch:
      fills_.AddPolygon(Corners(box), swatch.color);
      AddHatch({Vector(box.left, box.bottom), Vector(box.right(), box.top())},
               widths::kHatch * size_.unit, palette_.hatch, &thin_);
      thin_.AddOutline(Corners(box), palette_.rule);
      break;
    case Swatch::Kind::kOutline:
      bold_.AddOutline(Corners(Shrunk(box, 0.2 * box.height)), swatch.color);
      break;
    case Swatch::Kind::kLine:
      bold_.AddLine({box.left, center.y()}, {box.right(), center.y()}, swatch.color);
      break;
    case Swatch::Kind::kPoint:
      fills_.AddDisc(center, 0.7 * radius, swatch.color);
      break;
    case Swatch::Kind::kFrame: {
      const Vector origin = center - Vector(0.7 * radius, 0.7 * radius);
      bold_.AddLine(origin, origin + Vector(1.6 * radius, 0.0), palette_.axis_x);
      bold_.AddLine(origin, origin + Vector(0.0, 1.6 * radius), palette_.axis_y);
      break;
    }
    case Swatch::Kind::kRobot:
      fills_.AddPolygon(RobotOutline(Pose2(center, 0.0), 1.4 * radius), swatch.color);
      break;
  }
}

void AnnotationPen::DrawLegendEntry(const LegendEntry& entry, const Box& box) {
  Box text = box;
  const Box swatch = CutLeft(kSwatchWidth * size_.font, &text);
  DrawSwatch(entry.swatch,
             {swatch.left, box.center_y() - 0.45 * size_.font, 1.4 * size_.font, 0.9 * size_.font});
  Write(ShortenToFit(entry.label, Ink(), text.width), Ink(), Align::kLeft, text.left,
        text.center_y());
}

void AnnotationPen::DrawColorBar(const ColorBar& bar, Box box) {
  const Box title = CutTop(1.4 * size_.font, &box);
  Write(ShortenToFit(bar.title, Ink(), title.width), Ink(), Align::kLeft, title.left,
        title.center_y());
  const Box colors = Shrunk(CutTop(1.0 * size_.font, &box), 0.5 * size_.unit);
  constexpr int kSteps = 64;
  for (int i = 0; i < kSteps; ++i) {
    const double step = colors.width / kSteps;
    fills_.AddPolygon(Corners({colors.left + i * step, colors.bottom, step, colors.height}),
                      bar.colors.At((i + 0.5) / kSteps));
  }
  thin_.AddOutline(Corners(colors), palette_.rule);
  DrawTicks(bar.ticks, colors, CutTop(1.4 * size_.font, &box));
}

void AnnotationPen::DrawTicks(const std::vector<ColorBar::Tick>& ticks, const Box& colors,
                              const Box& labels) {
  std::vector<Box> written;  // a label that would touch one of these is left out
  for (const ColorBar::Tick& tick : ticks) {
    const double width = TextWidth(tick.label, FaintInk());
    const double x = colors.left + tick.place * colors.width;
    const double left = std::max(labels.left, std::min(x - 0.5 * width, labels.right() - width));
    const Box label{left, labels.bottom, width + 0.5 * size_.font, labels.height};
    const auto touches = [&](const Box& other) { return Overlap(label, other); };
    if (width > labels.width || std::any_of(written.begin(), written.end(), touches)) continue;
    written.push_back(label);
    thin_.AddLine({x, colors.bottom}, {x, colors.bottom - 0.25 * size_.font}, palette_.faint_ink);
    Write(tick.label, FaintInk(), Align::kLeft, left, labels.center_y() - 0.1 * size_.font);
  }
}

void AnnotationPen::DrawFact(const Fact& fact, const Box& box) {
  const std::string value = ShortenToFit(fact.value, Ink(), box.width);
  const double rest = box.width - TextWidth(value, Ink()) - kFactGap * size_.font;
  Write(ShortenToFit(fact.name, FaintInk(), rest), FaintInk(), Align::kLeft, box.left,
        box.center_y());
  Write(value, Ink(), Align::kRight, box.right(), box.center_y());
}

double AnnotationPen::DrawScaleBar(const FlatCamera& camera, const Box& box) {
  const double max_width = std::min(0.35 * box.width, 8.0 * size_.font);
  const double length = RoundLength(max_width * camera.meters_per_pixel);
  const double width = length / camera.meters_per_pixel;
  const double y = box.center_y();
  const double tick = 0.28 * size_.font;
  bold_.AddLine({box.left, y}, {box.left + width, y}, palette_.ink);
  thin_.AddLine({box.left, y - tick}, {box.left, y + tick}, palette_.ink);
  thin_.AddLine({box.left + width, y - tick}, {box.left + width, y + tick}, palette_.ink);
  const std::string label = LengthLabel(length);
  const double text_left = width + 0.4 * size_.font;
  if (text_left + TextWidth(label, Ink()) > box.width) return width;
  Write(label, Ink(), Align::kLeft, box.left + text_left, y);
  return text_left + TextWidth(label, Ink());
}

}  // namespace

Props DrawAnnotation(const Annotation& annotation, const Layout& layout, const Palette& palette) {
  AnnotationPen pen(layout.size, palette);
  const TextStyle title = TitleStyle(layout.size, palette);
  pen.Write(ShortenToFit(annotation.title, title, layout.title.width), title, Align::kLeft,
            layout.title.left, layout.title.center_y());
  pen.Write(JoinToFit(annotation.subtitle, pen.FaintInk(), layout.subtitle.width), pen.FaintInk(),
            Align::kLeft, layout.subtitle.left, layout.subtitle.center_y());
  for (std::size_t i = 0; i < layout.legend.size(); ++i) {
    pen.DrawLegendEntry(annotation.legend[i], layout.legend[i]);
  }
  for (std::size_t i = 0; i < layout.color_bars.size(); ++i) {
    pen.DrawColorBar(annotation.color_bars[i], layout.color_bars[i]);
  }
  for (std::size_t i = 0; i < layout.facts.size(); ++i) {
    pen.DrawFact(annotation.facts[i], layout.facts[i]);
  }
  return pen.Finish();
}

Props DrawPanelEdge(const PanelBoxes& boxes, const FlatCamera* camera,
                    const std::vector<std::string>& caption, const SheetSize& size,
                    const Palette& palette) {
  AnnotationPen pen(size, palette);
  pen.DrawOutline(Shrunk(boxes.frame, -0.5 * widths::kThin * size.unit));
  Box text = boxes.footer;
  const bool own_row = text.height > 2.0 * size.font;
  const Box bar = own_row ? CutTop(0.5 * text.height, &text) : text;
  const double bar_width = camera ? pen.DrawScaleBar(*camera, bar) + size.font : 0.0;
  if (!own_row) CutLeft(bar_width, &text);
  pen.Write(JoinToFit(caption, pen.FaintInk(), text.width), pen.FaintInk(), Align::kLeft, text.left,
            text.center_y());
  return pen.Finish();
}

}  // namespace loopscope
