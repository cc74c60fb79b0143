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
#include "render/vector/svg_names.h"

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

void Fill(const Color& color, cairo_t* canvas) {
  cairo_set_source_rgba(canvas, color.r / 255.0, color.g / 255.0, color.b / 255.0, color.a / 255.0);
  cairo_paint(canvas);
}

/// Of `panel` on a canvas with its `frame`, which is `height` high.
Placement PlacementOf(const Panel& panel, const Box& frame, double height, double unit) {
  const double scale = unit / panel.camera.meters_per_pixel;
  const Eigen::Vector2d flipped(scale, -scale);
  const Eigen::Matrix3d view_from_map = panel.side.value_or(SideView()).ViewFromMap();
  Placement placement;
  placement.turn = flipped.asDiagonal() * view_from_map.topRows<2>();
  placement.shift = unit * Eigen::Vector2d(frame.center_x(), height - frame.center_y()) -
                    flipped.cwiseProduct(panel.camera.center);
  placement.corner = unit * Eigen::Vector2d(frame.left, height - frame.top());
  placement.unit = unit;
  return placement;
}

/// Layers of a panel that are pixels in the file: those of the scene. What is drawn one after the
/// other becomes one image.
class LayersAsImage {
 public:
  LayersAsImage(const Panel& panel, const Placement& placement, cairo_t* canvas)
      : panel_(panel), placement_(placement), canvas_(canvas) {}

  /// `beneath` is what the image begins with, if it is not there yet.
  void Draw(vtkActor* actor, const Color& beneath) {
    const Box whole{0.0, 0.0, panel_.frame.width, panel_.frame.height};
    if (!image_) Begin(whole, beneath);
    DrawActor(actor, PlacementOf(panel_, whole, whole.height, 1.0), pixels_.get());
  }

  /// Puts the image onto the canvas, if there is one.
  void Finish() {
    if (!image_) return;
    pixels_.reset();
    cairo_save(canvas_);
    cairo_translate(canvas_, placement_.corner.x(), placement_.corner.y());
    cairo_scale(canvas_, placement_.unit, placement_.unit);
    cairo_set_source_surface(canvas_, image_.get(), 0.0, 0.0);
    cairo_paint(canvas_);
    cairo_restore(canvas_);
    image_.reset();
  }

 private:
  void Begin(const Box& whole, const Color& beneath) {
    const cairo_format_t format = beneath.a == 255 ? CAIRO_FORMAT_RGB24 : CAIRO_FORMAT_ARGB32;
    image_.reset(cairo_image_surface_create(format, static_cast<int>(std::ceil(whole.width)),
                                            static_cast<int>(std::ceil(whole.height))));
    pixels_ = CanvasOn(image_.get());
    Fill(beneath, pixels_.get());
  }

  const Panel& panel_;
  const Placement& placement_;
  cairo_t* canvas_;
  Surface image_{nullptr, &cairo_surface_destroy};
  Canvas pixels_{nullptr, &cairo_destroy};
};

bool BelongsInImage(vtkActor* actor) {
  constexpr double kMaxSize = 1.5e6;  // [bytes] of a layer
  return actor->GetTexture() != nullptr || VectorSizeOf(actor) > kMaxSize;
}

/// What is flat comes before all texts, as VTK draws it. An image at the bottom has no clear parts,
/// whose edges would be seen.
void DrawProps(const Panel& panel, const Placement& placement, cairo_t* canvas) {
  Color beneath = panel.canvas;
  LayersAsImage image(panel, placement, canvas);
  for (const LayerProp& layer : panel.props) {
    auto* const actor = vtkActor::SafeDownCast(layer.prop.Get());
    const bool is_at_rest = layer.when != LayerProp::When::kMoving;
    if (actor == nullptr || !actor->GetVisibility() || !is_at_rest) continue;
    if (BelongsInImage(actor)) {
      image.Draw(actor, beneath);
    } else {
      image.Finish();
      DrawActor(actor, placement, canvas);
    }
    beneath = {0, 0, 0, 0};
  }
  image.Finish();
  for (const LayerProp& layer : panel.props) {
    auto* const texts = vtkActor2D::SafeDownCast(layer.prop.Get());
    if (texts != nullptr && texts->GetVisibility()) DrawTexts(texts, placement, canvas);
  }
}

void DrawPanel(const Panel& panel, double height, double unit, cairo_t* canvas) {
  const Box& frame = panel.frame;
  const Placement placement = PlacementOf(panel, frame, height, unit);
  cairo_save(canvas);
  cairo_rectangle(canvas, placement.corner.x(), placement.corner.y(), unit * frame.width,
                  unit * frame.height);
  cairo_clip(canvas);
  Fill(panel.canvas, canvas);
  DrawProps(panel, placement, canvas);
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
  return format == VectorFormat::kSvg ? WithOwnNames(bytes) : bytes;
}

}  // namespace loopscope
