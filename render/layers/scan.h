// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include "core/geometry/pose2.h"
#include "core/sensor/range_data.h"
#include "render/palette.h"

namespace loopscope {

/// The points of a scan, `size` [px] wide.
vtkSmartPointer<vtkActor> ScanLayer(const PointCloud& points_in_scan, const Pose2& target_from_scan,
                                    const Color& color, double size);

/// A line from each point at the first pose to the same point at the second one.
vtkSmartPointer<vtkActor> MovesLayer(const PointCloud& points_in_scan,
                                     const Pose2& target_from_first,
                                     const Pose2& target_from_second, const Color& color,
                                     double line_width);

/// A line from the scanner to each return and each miss, `width` [px] wide.
vtkSmartPointer<vtkActor> RaysLayer(const RangeData& data, const Color& color, double width);

}  // namespace loopscope
