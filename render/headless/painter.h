// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vtkSmartPointer.h>

#include "core/slam/recording.h"
#include "render/headless/offscreen_window.h"
#include "render/picture.h"
#include "render/scene.h"
#include "render/view.h"

namespace loopscope {

class Ground;

/// Draws scenes without a display. All painters of a process must use the same back end: OpenGL is
/// loaded once. It belongs to one thread at a time.
class Painter {
 public:
  /// Throws std::runtime_error saying which back end failed, and where.
  explicit Painter(Backend backend);

  /// The scene, its pixels averaged down to those of the picture.
  Picture Draw(const Scene& scene);

  /// BuildScene with OversamplingOf, and Draw.
  Picture Draw(const Recording& recording, const ViewRequest& request);
  /// Likewise, of the recording of `cache`.
  Picture Draw(DerivedCache* cache, const ViewRequest& request);

 private:
  Picture Blend(const Ground& ground, const Scene& scene);

  vtkSmartPointer<OffscreenWindow> window_;
};

}  // namespace loopscope
