// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/ground.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

namespace loopscope {
namespace {

constexpr Color kNothing{0, 0, 0, 0};

Eigen::Vector2d PointOf(vtkPolyData* data, int index) {
  const double* const point = data->GetPoint(index);
  return {point[0], point[1]};
}

}  // namespace

Ground::Ground(Scene* scene) : width_(scene->width), paper_(scene->paper) {
  scene->paper = kNothing;
  for (Panel& panel : scene->panels) canvases_.push_back(TakeCanvas(&panel));
}

void Ground::PaintRow(int y, Color* row) const {
  std::fill_n(row, width_, paper_);
  for (const Canvas& canvas : canvases_) {
    if (!canvas.rows.Contains(y)) continue;
    std::fill(row + canvas.columns.begin, row + canvas.columns.end, canvas.color);
    for (const Image& image : canvas.images) image.PaintRow(y, row);
  }
}

bool Ground::IsLikeRowBeneath(int y) const {
  return std::all_of(canvases_.begin(), canvases_.end(), [&](const Canvas& canvas) {
    const auto is_alike = [&](const Image& image) {
      return image.CellRowAt(y) == image.CellRowAt(y - 1);
    };
    return canvas.rows.Contains(y) == canvas.rows.Contains(y - 1) &&
           std::all_of(canvas.images.begin(), canvas.images.end(), is_alike);
  });
}

std::optional<int> Ground::Image::CellRowAt(int y) const {
  if (!rows.pixels.Contains(y)) return std::nullopt;
  return rows.cells[y - rows.pixels.begin];
}

void Ground::Image::PaintRow(int y, Color* row) const {
  const std::optional<int> cell_row = CellRowAt(y);
  if (!cell_row) return;
  const auto* const cells = static_cast<const Color*>(image->GetScalarPointer(0, *cell_row, 0));
  Color* pixel = row + columns.pixels.begin;
  for (const int column : columns.cells) {
    const Color& cell = cells[column];
    if (cell.a == 255) {
      *pixel = cell;
    } else if (cell.a > 0) {
      *pixel = Blend(*pixel, WithOpacity(cell, 1.0), cell.a / 255.0);
    }
    ++pixel;
  }
}

Ground::Canvas Ground::TakeCanvas(Panel* panel) {
  const auto pixel = [](double place) { return static_cast<int>(std::lround(place)); };
  const Box& frame = panel->frame;
  Canvas canvas{panel->canvas,
                {pixel(frame.left), pixel(frame.right())},
                {pixel(frame.bottom), pixel(frame.top())},
                {}};
  panel->canvas = kNothing;
  auto next = panel->props.begin();
  for (; next != panel->props.end(); ++next) {
    std::optional<Image> image = ImageOf(*next, *panel, canvas);
    if (!image) break;
    canvas.images.push_back(std::move(*image));
  }
  panel->props.erase(panel->props.begin(), next);
  return canvas;
}

/// None if the layer is no cell image, or lies aslant in the picture, or is blended as a whole.
std::optional<Ground::Image> Ground::ImageOf(const LayerProp& layer, const Panel& panel,
                                             const Canvas& canvas) {
  auto* const actor = vtkActor::SafeDownCast(layer.prop);
  if (actor == nullptr || actor->GetTexture() == nullptr || panel.side ||
      layer.when == LayerProp::When::kMoving || actor->GetProperty()->GetOpacity() != 1.0) {
    return std::nullopt;
  }
  // Counter-clockwise from the lower left corner of the image.
  vtkPolyData* const rectangle = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
  const Eigen::Vector2d min = PointOf(rectangle, 0);
  const Eigen::Vector2d max = PointOf(rectangle, 2);
  const bool is_upright = PointOf(rectangle, 1) == Eigen::Vector2d(max.x(), min.y()) &&
                          min.x() < max.x() && min.y() < max.y();
  if (!is_upright) return std::nullopt;

  vtkImageData* const image = actor->GetTexture()->GetInput();
  const int* const size = image->GetDimensions();
  const Eigen::Vector2d cells_per_meter(size[0] / (max.x() - min.x()),
                                        size[1] / (max.y() - min.y()));
  const double meters_per_pixel =
      panel.camera.meters_per_pixel * panel.frame.height / (canvas.rows.end - canvas.rows.begin);
  const Eigen::Vector2d middle(0.5 * (canvas.columns.begin + canvas.columns.end),
                               0.5 * (canvas.rows.begin + canvas.rows.end));
  const Eigen::Vector2d step = meters_per_pixel * cells_per_meter;
  const Eigen::Vector2d origin =
      (panel.camera.center - min).cwiseProduct(cells_per_meter) - step.cwiseProduct(middle);
  return Image{image, CellsOf(canvas.columns, origin.x(), step.x(), size[0]),
               CellsOf(canvas.rows, origin.y(), step.y(), size[1])};
}

/// The middle of pixel i is `origin` + (i + 0.5) `step` from the first edge of the image [cells].
Ground::Cells Ground::CellsOf(const Range& pixels, double origin, double step, int num_cells) {
  const auto cell_of = [&](int pixel) { return std::floor(origin + (pixel + 0.5) * step); };
  Cells cells{pixels, {}};
  while (cells.pixels.begin < pixels.end && cell_of(cells.pixels.begin) < 0) ++cells.pixels.begin;
  for (int pixel = cells.pixels.begin; pixel < pixels.end; ++pixel) {
    if (cell_of(pixel) >= num_cells) break;
    cells.cells.push_back(static_cast<int>(cell_of(pixel)));
  }
  cells.pixels.end = cells.pixels.begin + static_cast<int>(cells.cells.size());
  return cells;
}

}  // namespace loopscope
