// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include "core/geometry/pose2.h"
#include "core/grid/cell.h"
#include "render/palette.h"

namespace loopscope {

/// A colour for each cell of a box; clear at first.
class CellImage {
 public:
  explicit CellImage(const CellBox& box);
  /// Likewise, but each cell must be set before it is looked at.
  static CellImage Unpainted(const CellBox& box);
  CellImage(CellImage&&) = default;
  CellImage& operator=(CellImage&&) = default;

  const CellBox& box() const { return box_; }
  /// Clear outside of the box.
  Color At(CellIndex cell) const {
    return box_.Contains(cell) ? pixels_[box_.FlatIndex(cell)] : Color{0, 0, 0, 0};
  }
  /// `cell` must lie in the box.
  void Set(CellIndex cell, const Color& color) { pixels_[box_.FlatIndex(cell)] = color; }

  /// RGBA, row-major, lowest y first; of this image, not a copy. The box must not be empty.
  vtkImageData* vtk() const { return image_; }
  /// Whether a layer or somebody else has the pixels, too.
  bool IsShown() const { return image_ != nullptr && image_->GetReferenceCount() > 1; }

 private:
  CellImage() = default;

  CellBox box_;
  vtkSmartPointer<vtkImageData> image_;
  Color* pixels_ = nullptr;  // of image_
};

/// The image as one rectangle, every cell in one colour to its edges. `resolution` is the edge of a
/// cell [m].
vtkSmartPointer<vtkActor> CellImageLayer(const CellImage& image, const Pose2& target_from_grid,
                                         double resolution);

}  // namespace loopscope
