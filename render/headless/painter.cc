// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <cassert>
#include <cstdint>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

#include "render/headless/shrinking.h"

namespace loopscope {

Painter::Painter(Backend backend) : window_(vtkSmartPointer<OffscreenWindow>::New()) {
  window_->Open(MakeGlContext(backend));
}

Picture Painter::Draw(const Scene& scene) {
  window_->SetSize(scene.width, scene.height);
  Show(scene, window_);
  window_->Render();
  const int factor = scene.oversampling;
  assert(factor == 1 || factor == 2);
  Picture picture{scene.width / factor, scene.height / factor, {}};
  const std::size_t row_size = 3 * static_cast<std::size_t>(picture.width);
  picture.rgb.resize(row_size * picture.height);
  vtkNew<vtkUnsignedCharArray> rgba;
  for (int y = 0; y < picture.height; ++y) {  // from the lowest row up; a picture begins above
    window_->ReadRows(y * factor, factor, rgba);
    const std::uint8_t* const rows = rgba->GetPointer(0);
    std::uint8_t* const rgb = picture.rgb.data() + (picture.height - 1 - y) * row_size;
    if (factor == 1) {
      DropAlpha(rows, picture.width, rgb);
    } else {
      ShrinkRows(rows, rows + kNumChannels * scene.width, picture.width, rgb);
    }
  }
  Clear(window_);  // whoever draws the next scene may change what this one showed
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
