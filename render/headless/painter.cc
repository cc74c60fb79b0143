// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <vector>
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
  std::vector<std::uint8_t> mean_of_sum(255 * count + 1);  // rounded; a division takes longer
  for (int sum = 0; sum <= 255 * count; ++sum) {
    mean_of_sum[sum] = static_cast<std::uint8_t>((sum + count / 2) / count);
  }
  const std::size_t row_size = 3 * static_cast<std::size_t>(width);
  std::uint8_t* out = picture.rgb.data();
  for (int y = picture.height - 1; y >= 0; --y) {
    const std::uint8_t* square = pixels + static_cast<std::size_t>(y) * factor * row_size;
    for (int x = 0; x < picture.width; ++x, square += 3 * factor) {
      for (int channel = 0; channel < 3; ++channel) {
        int sum = 0;
        for (int dy = 0; dy < factor; ++dy) {
          const std::uint8_t* const row = square + dy * row_size + channel;
          for (int dx = 0; dx < factor; ++dx) sum += row[3 * dx];
        }
        *out++ = mean_of_sum[sum];
      }
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
