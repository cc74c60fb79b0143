// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/cairo_texts.h"

#include <memory>
#include <vtkLabeledDataMapper.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTextActor.h>

#include <cairo-ft.h>
#include <fontconfig/fontconfig.h>

namespace loopscope {
namespace {

void UseFont(const char* file, double size, cairo_t* canvas) {
  const std::unique_ptr<FcPattern, decltype(&FcPatternDestroy)> pattern(FcPatternCreate(),
                                                                        &FcPatternDestroy);
  FcPatternAddString(pattern.get(), FC_FILE, reinterpret_cast<const FcChar8*>(file));
  const std::unique_ptr<cairo_font_face_t, decltype(&cairo_font_face_destroy)> face(
      cairo_ft_font_face_create_for_pattern(pattern.get()), &cairo_font_face_destroy);
  cairo_set_font_face(canvas, face.get());
  cairo_set_font_size(canvas, size);
}

/// What VTK takes for the height of any line of text; y points down from the baseline.
struct LineBox {
  double top = 0.0;
  double bottom = 0.0;
};

LineBox LineBoxOf(cairo_t* canvas) {
  cairo_text_extents_t extents;
  cairo_text_extents(canvas, "_/7Agfy", &extents);
  return {extents.y_bearing, extents.y_bearing + extents.height};
}

/// From the anchor to the left end of the baseline.
Eigen::Vector2d FromAnchor(vtkTextProperty* property, double width, const LineBox& line) {
  const double share = property->GetJustification() == VTK_TEXT_LEFT       ? 0.0
                       : property->GetJustification() == VTK_TEXT_CENTERED ? 0.5
                                                                           : 1.0;
  const double y = property->GetVerticalJustification() == VTK_TEXT_BOTTOM ? line.bottom
                   : property->GetVerticalJustification() == VTK_TEXT_CENTERED
                       ? 0.5 * (line.top + line.bottom)
                       : line.top;
  return {-share * width, -y};
}

void Use(const double* rgb, double opacity, cairo_t* canvas) {
  cairo_set_source_rgba(canvas, rgb[0], rgb[1], rgb[2], opacity);
}

void DrawLabels(vtkLabeledDataMapper* mapper, const Placement& placement, cairo_t* canvas) {
  vtkPolyData* const data = vtkPolyData::SafeDownCast(mapper->GetInput());
  auto* const texts = vtkStringArray::SafeDownCast(
      data->GetPointData()->GetAbstractArray(mapper->GetFieldDataName()));
  for (vtkIdType i = 0; i < texts->GetNumberOfValues(); ++i) {
    DrawText(texts->GetValue(i), mapper->GetLabelTextProperty(), placement.At(data->GetPoint(i)),
             placement.unit, canvas);
  }
}

}  // namespace

void DrawText(const std::string& text, vtkTextProperty* property, const Eigen::Vector2d& anchor,
              double unit, cairo_t* canvas) {
  UseFont(property->GetFontFile(), unit * property->GetFontSize(), canvas);
  cairo_text_extents_t extents;
  cairo_text_extents(canvas, text.c_str(), &extents);
  const LineBox line = LineBoxOf(canvas);
  const Eigen::Vector2d start = anchor + FromAnchor(property, extents.x_advance, line);
  if (property->GetBackgroundOpacity() > 0.0) {
    Use(property->GetBackgroundColor(), property->GetBackgroundOpacity(), canvas);
    cairo_rectangle(canvas, start.x(), start.y() + line.top, extents.x_advance,
                    line.bottom - line.top);
    cairo_fill(canvas);
  }
  Use(property->GetColor(), property->GetOpacity(), canvas);
  cairo_move_to(canvas, start.x(), start.y());
  cairo_show_text(canvas, text.c_str());
}

void DrawTexts(vtkActor2D* actor, const Placement& placement, cairo_t* canvas) {
  if (auto* const text = vtkTextActor::SafeDownCast(actor)) {
    const double anchor[3] = {text->GetPosition()[0], text->GetPosition()[1], 0.0};
    DrawText(text->GetInput(), text->GetTextProperty(), placement.At(anchor), placement.unit,
             canvas);
  } else if (auto* const labels = vtkLabeledDataMapper::SafeDownCast(actor->GetMapper())) {
    DrawLabels(labels, placement, canvas);
  }
}

}  // namespace loopscope
