// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/vector/cairo_marks.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>
#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include "render/palette.h"

namespace loopscope {
namespace {

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

/// The cells of one kind of an actor, one after the other.
class Marks {
 public:
  Marks(vtkActor* actor, const Placement& placement, cairo_t* canvas)
      : data_(vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput()),
        opacity_(actor->GetProperty()->GetOpacity()),
        placement_(placement),
        canvas_(canvas) {}

  vtkPolyData* data() const { return data_; }

  /// Calls `add` to make a path of each cell, and `paint` with its colour to paint it. Neighbours
  /// of the same opaque colour are one path if `joined`.
  template <typename Add, typename Paint>
  void Draw(vtkCellArray* cells, bool joined, const Add& add, const Paint& paint) {
    const auto cell = vtk::TakeSmartPointer(cells->NewIterator());
    Color current;
    bool has_path = false;
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* points = nullptr;
      cell->GetCurrentCell(count, points);
      if (count == 0) continue;
      const Color color = ColorOf(points[0]);
      const bool continues = has_path && joined && color == current && color.a == 255;
      if (has_path && !continues) paint(current);
      if (!continues) Use(color);
      current = color;
      has_path = true;
      add(count, points);
    }
    if (has_path) paint(current);
  }

  Eigen::Vector2d PlaceOf(vtkIdType point) const { return placement_.At(data_->GetPoint(point)); }
  void MoveTo(vtkIdType point) const {
    const Eigen::Vector2d p = PlaceOf(point);
    cairo_move_to(canvas_, p.x(), p.y());
  }
  void LineTo(vtkIdType point) const {
    const Eigen::Vector2d p = PlaceOf(point);
    cairo_line_to(canvas_, p.x(), p.y());
  }

 private:
  Color ColorOf(vtkIdType point) const {
    vtkDataArray* const colors = data_->GetPointData()->GetScalars();
    const auto channel = [&](int c) {
      return static_cast<std::uint8_t>(colors->GetComponent(point, c));
    };
    return WithOpacity({channel(0), channel(1), channel(2)}, opacity_ * channel(3) / 255.0);
  }

  void Use(const Color& color) const {
    cairo_set_source_rgba(canvas_, color.r / 255.0, color.g / 255.0, color.b / 255.0,
                          color.a / 255.0);
  }

  vtkPolyData* data_;
  double opacity_;
  const Placement& placement_;
  cairo_t* canvas_;
};

/// A line without length: its ends make it a dot.
void DrawPoints(vtkProperty* property, double unit, cairo_t* canvas, Marks* marks) {
  cairo_set_line_width(canvas, unit * property->GetPointSize());
  cairo_set_line_cap(
      canvas, property->GetRenderPointsAsSpheres() ? CAIRO_LINE_CAP_ROUND : CAIRO_LINE_CAP_SQUARE);
  const auto add = [&](vtkIdType count, const vtkIdType* points) {
    for (vtkIdType i = 0; i < count; ++i) {
      marks->MoveTo(points[i]);
      marks->LineTo(points[i]);
    }
  };
  marks->Draw(marks->data()->GetVerts(), true, add, [&](const Color&) { cairo_stroke(canvas); });
}

void DrawLines(vtkProperty* property, double unit, cairo_t* canvas, Marks* marks) {
  cairo_set_line_width(canvas, unit * property->GetLineWidth());
  cairo_set_line_cap(canvas, CAIRO_LINE_CAP_BUTT);
  cairo_set_line_join(canvas, CAIRO_LINE_JOIN_ROUND);
  const auto add = [&](vtkIdType count, const vtkIdType* points) {
    marks->MoveTo(points[0]);
    const bool is_closed =
        count > 2 && marks->PlaceOf(points[0]) == marks->PlaceOf(points[count - 1]);
    for (vtkIdType i = 1; i < count - (is_closed ? 1 : 0); ++i) marks->LineTo(points[i]);
    if (is_closed) cairo_close_path(canvas);
  };
  marks->Draw(marks->data()->GetLines(), true, add, [&](const Color&) { cairo_stroke(canvas); });
}

/// An opaque polygon gets an edge, so that no seam is seen between it and its neighbour.
void DrawPolygons(double unit, cairo_t* canvas, Marks* marks) {
  constexpr double kEdge = 0.5;  // [px]
  const auto add = [&](vtkIdType count, const vtkIdType* points) {
    marks->MoveTo(points[0]);
    for (vtkIdType i = 1; i < count; ++i) marks->LineTo(points[i]);
    cairo_close_path(canvas);
  };
  const auto paint = [&](const Color& color) {
    color.a == 255 ? cairo_fill_preserve(canvas) : cairo_fill(canvas);
    if (color.a == 255) cairo_stroke(canvas);
  };
  cairo_set_line_width(canvas, kEdge * unit);
  marks->Draw(marks->data()->GetPolys(), false, add, paint);
}

/// Cairo's pixels: 0xAARRGGBB, the colours multiplied by the opacity, the highest row first.
std::vector<std::uint32_t> PixelsOf(vtkImageData* image) {
  const int* const size = image->GetDimensions();
  const auto* const rgba = static_cast<const std::uint8_t*>(image->GetScalarPointer());
  std::vector<std::uint32_t> pixels;
  pixels.reserve(static_cast<std::size_t>(size[0]) * size[1]);
  for (int y = size[1] - 1; y >= 0; --y) {
    const std::uint8_t* pixel = rgba + 4 * static_cast<std::size_t>(y) * size[0];
    for (int x = 0; x < size[0]; ++x, pixel += 4) {
      const std::uint32_t a = pixel[3];
      const auto premultiplied = [&](int c) { return (pixel[c] * a + 127) / 255; };
      pixels.push_back(a << 24 | premultiplied(0) << 16 | premultiplied(1) << 8 | premultiplied(2));
    }
  }
  return pixels;
}

/// The rectangle of CellImageLayer begins with its lower left corner, counter-clockwise.
void DrawImage(vtkActor* actor, vtkPolyData* rectangle, const Placement& placement,
               cairo_t* canvas) {
  vtkImageData* const image = actor->GetTexture()->GetInput();
  const int* const size = image->GetDimensions();
  std::vector<std::uint32_t> pixels = PixelsOf(image);
  const Surface surface(
      cairo_image_surface_create_for_data(reinterpret_cast<unsigned char*>(pixels.data()),
                                          CAIRO_FORMAT_ARGB32, size[0], size[1], 4 * size[0]),
      &cairo_surface_destroy);
  const Eigen::Vector2d lower_left = placement.At(rectangle->GetPoint(0));
  const Eigen::Vector2d upper_right = placement.At(rectangle->GetPoint(2));
  const Eigen::Vector2d upper_left = placement.At(rectangle->GetPoint(3));
  const Eigen::Vector2d x = (upper_right - upper_left) / size[0];
  const Eigen::Vector2d y = (lower_left - upper_left) / size[1];
  cairo_matrix_t canvas_from_image;
  cairo_matrix_init(&canvas_from_image, x.x(), x.y(), y.x(), y.y(), upper_left.x(), upper_left.y());
  cairo_save(canvas);
  cairo_transform(canvas, &canvas_from_image);
  cairo_set_source_surface(canvas, surface.get(), 0.0, 0.0);
  cairo_pattern_set_filter(cairo_get_source(canvas), CAIRO_FILTER_NEAREST);
  cairo_paint_with_alpha(canvas, actor->GetProperty()->GetOpacity());
  cairo_restore(canvas);
  cairo_surface_finish(surface.get());
}

}  // namespace

void DrawActor(vtkActor* actor, const Placement& placement, cairo_t* canvas) {
  Marks marks(actor, placement, canvas);
  if (marks.data()->GetNumberOfPoints() == 0) return;
  if (actor->GetTexture() != nullptr) {
    DrawImage(actor, marks.data(), placement, canvas);
    return;
  }
  DrawPoints(actor->GetProperty(), placement.unit, canvas, &marks);
  DrawLines(actor->GetProperty(), placement.unit, canvas, &marks);
  DrawPolygons(placement.unit, canvas, &marks);
}

double VectorSizeOf(vtkActor* actor) {
  constexpr double kPath = 180.0;
  constexpr double kPoint = 20.0;
  vtkPolyData* const data = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
  vtkDataArray* const colors = data->GetPointData()->GetScalars();
  double size = kPoint * static_cast<double>(data->GetNumberOfPoints());
  const bool is_joined = data->GetNumberOfPoints() == 0 || colors->GetComponent(0, 3) == 255.0;
  if (!is_joined) size += kPath * static_cast<double>(data->GetNumberOfCells());
  return size;
}

}  // namespace loopscope
