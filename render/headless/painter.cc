// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <vector>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "render/headless/blending.h"
#include "render/headless/ground.h"
#include "render/headless/shrinking.h"
#include "render/parallel.h"

namespace loopscope {
namespace {

/// Rows `first` to before `last` of the picture, from the lowest up. `over` are the rows of the
/// scene that make them up.
void BlendRows(const Ground& ground, const Scene& scene, int first, int last, const Color* over,
               Picture* picture) {
  const int factor = scene.oversampling;
  assert(factor == 1 || factor == 2);
  std::vector<Color> ground_row(scene.width);
  std::vector<Color> rows(static_cast<std::size_t>(factor) * scene.width);
  for (int y = first; y < last; ++y) {
    for (int i = 0; i < factor; ++i) {
      const int row = y * factor + i;
      if (row == first * factor || !ground.IsLikeRowBeneath(row)) {
        ground.PaintRow(row, ground_row.data());
      }
      BlendRow(over, ground_row.data(), scene.width,
               rows.data() + static_cast<std::size_t>(i) * scene.width);
      over += scene.width;
    }
    const auto* const rgba = reinterpret_cast<const std::uint8_t*>(rows.data());
    const int from_top = picture->height - 1 - y;
    std::uint8_t* const rgb =
        picture->rgb.data() + 3 * static_cast<std::size_t>(from_top) * picture->width;
    if (factor == 1) {
      DropAlpha(rgba, picture->width, rgb);
    } else {
      ShrinkRows(rgba, rgba + kNumChannels * scene.width, picture->width, rgb);
    }
  }
}

/// Whether one thing of the scene can hide another behind it. To fill a depth buffer takes longer
/// than to draw a map.
bool HasDepth(const Scene& scene) {
  return std::any_of(scene.panels.begin(), scene.panels.end(),
                     [](const Panel& panel) { return panel.side.has_value(); });
}

}  // namespace

Painter::Painter(Backend backend) : window_(vtkSmartPointer<OffscreenWindow>::New()) {
  window_->Open(MakeGlContext(backend));
}

Picture Painter::Draw(const Scene& scene) {
  Scene foreground = scene;
  const Ground ground(&foreground);
  window_->SetSize(scene.width, scene.height);
  window_->SetHasDepth(HasDepth(scene));
  Show(foreground, window_);
  window_->Render();
  const Picture picture = Blend(ground, scene);
  Clear(window_);  // whoever draws the next scene may change what this one showed
  return picture;
}

/// What the window rendered over the ground, some rows after the others: a scene may be large.
Picture Painter::Blend(const Ground& ground, const Scene& scene) {
  constexpr int kRowsAtOnce = 256;  // of the picture
  constexpr int kRowsOfPart = 8;
  const int factor = scene.oversampling;
  Picture picture{scene.width / factor, scene.height / factor, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) * picture.height);
  vtkNew<vtkUnsignedCharArray> rendered;
  for (int first = 0; first < picture.height; first += kRowsAtOnce) {
    const int count = std::min(kRowsAtOnce, picture.height - first);
    window_->ReadRows(first * factor, count * factor, rendered);
    const auto* const over = reinterpret_cast<const Color*>(rendered->GetPointer(0));
    ParallelFor((count + kRowsOfPart - 1) / kRowsOfPart, [&](int part) {
      const int begin = part * kRowsOfPart;
      const int end = std::min(begin + kRowsOfPart, count);
      BlendRows(ground, scene, first + begin, first + end,
                over + static_cast<std::size_t>(begin) * factor * scene.width, &picture);
    });
  }
  return picture;
}
Picture Painter::Draw(const Recording& recording, const ViewRequest& request) {
  DerivedCache cache(recording);
  return Draw(&cache, request);
}

Picture Painter::Draw(DerivedCache* cache, const ViewRequest& request) {
  return Draw(BuildScene(cache, request, OversamplingOf(request)));
}

}  // namespace loopscope
