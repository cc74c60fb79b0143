// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkTexture.h>

#include <Eigen/Core>

#include "render/palette.h"

namespace loopscope {

/// What a layer draws.
inline vtkPolyData* DataOf(vtkActor* layer) {
  return vtkPolyDataMapper::SafeDownCast(layer->GetMapper())->GetInput();
}

inline Eigen::Vector2d PointOf(vtkActor* layer, vtkIdType index) {
  const double* const point = DataOf(layer)->GetPoint(index);
  return {point[0], point[1]};
}

inline Color ColorOf(vtkDataArray* colors, vtkIdType index) {
  const auto channel = [&](int c) {
    return static_cast<std::uint8_t>(colors->GetComponent(index, c));
  };
  return {channel(0), channel(1), channel(2), channel(3)};
}

inline Color ColorOf(vtkActor* layer, vtkIdType index) {
  return ColorOf(DataOf(layer)->GetPointData()->GetScalars(), index);
}

/// The image on a layer.
inline vtkImageData* ImageOf(vtkActor* layer) { return layer->GetTexture()->GetInput(); }

inline void PrintTo(const Color& color, std::ostream* out) {
  *out << "rgba(" << int{color.r} << ", " << int{color.g} << ", " << int{color.b} << ", "
       << int{color.a} << ")";
}

}  // namespace loopscope
