// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

namespace loopscope {
namespace {

/// Averages squares of `factor` pixels, and turns the image upside down. `pixels` are RGB from the
/// lowest row up.
Picture ShrinkAndFlip(const std::uint8_t* pixels, int width, int height, int factor) {
  Picture picture{width / factor, height / factor, {}};
  picture.rgb.resize(3 * static_cast<std::size_t>(picture.width) * picture.height);
  const int count = factor * factor;
  std::size_t out = 0;
  for (int y = picture.height - 1; y >= 0; --y) {
    for (int x = 0; x < 3 * picture.width; ++x) {
      int sum = 0;
      const std::size_t column = static_cast<std::size_t>(x / 3) * factor * 3 + x % 3;
      for (int dy = 0; dy < factor; ++dy) {
        const std::size_t row = static_cast<std::size_t>(y * factor + dy) * width * 3;
        for (int dx = 0; dx < factor; ++dx) sum += pixels[row + column + 3 * dx];
      }
      picture.rgb[out++] = static_cast<std::uint8_t>((sum + count / 2) / count);
    }
  }
  return picture;
}

}  // namespace

Painter::Painter(Backend backend) : window_(vtkSmartPointer<OffscreenWindow>::New()) {
  window_->Open(MakeGlContext(backend));
}

Picture Painter::Draw(const Scene& scene) {
  window_->SetSize(scene.width, scene.height);
  Show(scene, window_);
  window_->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  constexpr int kBackBuffer = 0;
  constexpr int kBothEyes = 0;
  window_->GetPixelData(0, 0, scene.width - 1, scene.height - 1, kBackBuffer, pixels, kBothEyes);
  return ShrinkAndFlip(pixels->GetPointer(0), scene.width, scene.height, scene.oversampling);
}

Picture Painter::Draw(const Recording& recording, const ViewRequest& request) {
  DerivedCache cache(recording);
  return Draw(&cache, request);
}

Picture Painter::Draw(DerivedCache* cache, const ViewRequest& request) {
  return Draw(BuildScene(cache, request, OversamplingOf(request)));
}

}  // namespace loopscope
