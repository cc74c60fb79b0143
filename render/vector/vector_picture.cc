// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/vector_picture.h"

#include <cmath>
#include <memory>
#include <stdexcept>
#include <vtkActor2D.h>

#include <cairo-pdf.h>
#include <cairo-svg.h>

#include "render/vector/cairo_marks.h"
#include "render/vector/cairo_texts.h"
#include "render/vector/svg_images.h"

namespace loopscope {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;
using Canvas = std::unique_ptr<cairo_t, decltype(&cairo_destroy)>;

void Require(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw std::runtime_error(std::string("cairo: ") + cairo_status_to_string(status));
}

Canvas CanvasOn(cairo_surface_t* surface) {
  Canvas canvas(cairo_create(surface), &cairo_destroy);
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(canvas.get(), options);
  cairo_font_options_destroy(options);
  return canvas;
}

cairo_status_t Append(void* document, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(document)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

/// As large as the picture. It is written to `document`.
Surface Document(const Scene& scene, VectorFormat format, std::string* document) {
  const double width = static_cast<double>(scene.width) / scene.oversampling;
  const double height = static_cast<double>(scene.height) / scene.oversampling;
  if (format == VectorFormat::kSvg) {
    Surface svg(cairo_svg_surface_create_for_stream(&Append, document, width, height),
                &cairo_surface_destroy);
    cairo_svg_surface_set_document_unit(svg.get(), CAIRO_SVG_UNIT_PX);
    return svg;
  }
  Surface pdf(cairo_pdf_surface_create_for_stream(&Append, document, width, height),
              &cairo_surface_destroy);
  // The same bytes at any time of day.
  cairo_pdf_surface_set_metadata(pdf.get(), CAIRO_PDF_METADATA_CREATE_DATE, "");
  return pdf;
}

Placement PlacementOf(const FlatCamera& camera, const Box& frame, double height, double unit) {
  const double scale = unit / camera.meters_per_pixel;
  Placement placement;
  placement.turn << scale, 0.0, 0.0, 0.0, -scale, 0.0;
  placement.shift = Eigen::Vector2d(unit * frame.center_x() - scale * camera.center.x(),
                                    unit * (height - frame.center_y()) + scale * camera.center.y());
  placement.unit = unit;
  return placement;
}

/// The marks of a layer as pixels of the scene: for more of them than a file can hold.
void DrawAsImage(vtkActor* actor, const Panel& panel, const Placement& placement, cairo_t* canvas) {
  const Surface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32,
                                                 static_cast<int>(std::ceil(panel.frame.width)),
                                                 static_cast<int>(std::ceil(panel.frame.height))),
                      &cairo_surface_destroy);
  const Canvas pixels = CanvasOn(image.get());
  const Box whole{0.0, 0.0, panel.frame.width, panel.frame.height};
  DrawActor(actor, PlacementOf(panel.camera, whole, whole.height, 1.0), pixels.get());
  cairo_surface_flush(image.get());
  cairo_save(canvas);
  double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
  cairo_clip_extents(canvas, &left, &top, &right, &bottom);
  cairo_translate(canvas, left, top);
  cairo_scale(canvas, placement.unit, placement.unit);
  cairo_set_source_surface(canvas, image.get(), 0.0, 0.0);
  cairo_paint(canvas);
  cairo_restore(canvas);
}

/// What is flat comes before all texts, as VTK draws it.
void DrawProps(const Panel& panel, const Placement& placement, cairo_t* canvas) {
  constexpr double kMaxSize = 1.5e6;  // [bytes] of a layer
  for (const auto& prop : panel.props) {
    auto* const actor = vtkActor::SafeDownCast(prop);
    if (actor == nullptr || !actor->GetVisibility()) continue;
    if (VectorSizeOf(actor) > kMaxSize) {
      DrawAsImage(actor, panel, placement, canvas);
    } else {
      DrawActor(actor, placement, canvas);
    }
  }
  for (const auto& prop : panel.props) {
    auto* const texts = vtkActor2D::SafeDownCast(prop);
    if (texts != nullptr && texts->GetVisibility()) DrawTexts(texts, placement, canvas);
  }
}

void DrawPanel(const Panel& panel, double height, double unit, cairo_t* canvas) {
  const Box& frame = panel.frame;
  cairo_save(canvas);
  cairo_rectangle(canvas, unit * frame.left, unit * (height - frame.top()), unit * frame.width,
                  unit * frame.height);
  cairo_clip(canvas);
  const Color& color = panel.canvas;
  cairo_set_source_rgb(canvas, color.r / 255.0, color.g / 255.0, color.b / 255.0);
  cairo_paint(canvas);
  DrawProps(panel, PlacementOf(panel.camera, frame, height, unit), canvas);
  cairo_restore(canvas);
}

}  // namespace

std::string EncodeVectorPicture(const Scene& scene, VectorFormat format) {
  std::string bytes;
  {
    const Surface document = Document(scene, format, &bytes);
    const Canvas canvas = CanvasOn(document.get());
    const double unit = 1.0 / scene.oversampling;
    DrawPanel(SheetOf(scene), scene.height, unit, canvas.get());
    for (const Panel& panel : scene.panels) DrawPanel(panel, scene.height, unit, canvas.get());
    Require(cairo_status(canvas.get()));
    cairo_surface_finish(document.get());
    Require(cairo_surface_status(document.get()));
  }
  return format == VectorFormat::kSvg ? WithFinishedImages(bytes) : bytes;
}

}  // namespace loopscope
