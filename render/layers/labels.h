// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>
#include <vtkActor2D.h>
#include <vtkSmartPointer.h>

#include <Eigen/Core>

#include "render/scene.h"
#include "render/text.h"

namespace loopscope {

struct Label {
  Eigen::Vector2d anchor = Eigen::Vector2d::Zero();  ///< [m] below the left end of the text
  std::string text;
  double height = 0.0;  ///< [m] of the anchor
};

/// Those of `labels` that can be written without touching an earlier one or the edge of the panel.
std::vector<Label> WithoutOverlaps(const std::vector<Label>& labels, const FlatCamera& camera,
                                   const Box& frame, const TextStyle& style);

/// The label, moved no farther than needed for its text to lie within the panel.
Label MovedInside(const Label& label, const FlatCamera& camera, const Box& frame,
                  const TextStyle& style);

/// Each text at its anchor, on a half clear plate of colour `plate`.
vtkSmartPointer<vtkActor2D> LabelsLayer(const std::vector<Label>& labels, const TextStyle& style,
                                        const Color& plate);

}  // namespace loopscope
