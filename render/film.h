// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/slam/recording.h"
#include "render/view.h"

namespace loopscope {

/// The steps first, first + stride, ... up to `last` at most.
struct StepRange {
  int first = 0;
  int last = 0;
  int stride = 1;

  int count() const { return (last - first) / stride + 1; }
  int step(int index) const { return first + index * stride; }
};

/// "FIRST:LAST" or "FIRST:LAST:STRIDE" out of `num_steps` steps; an empty FIRST is the first step,
/// an empty LAST the last one. Throws std::invalid_argument saying what was expected.
StepRange ParseStepRange(const std::string& text, int num_steps);

/// `request` with the camera that it has at `step`, for the views in the frame of the map, so that
/// a film does not jump. What the request itself says of the camera stays, and so do the other
/// views: they follow a submap. Throws as BuildScene does.
ViewRequest WithCameraOf(DerivedCache* cache, ViewRequest request, int step);

}  // namespace loopscope
