// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

namespace loopscope {
namespace {

constexpr int kNumChannels = 4;  // RGBA is what OpenGL has

/// Averages squares of pixels, RGBA to RGB. What compilers do not make fast by themselves: of a
/// pixel the four channels are summed in two words, 16 bits each, which holds up to 16 x 16 pixels.
class Shrinking {
 public:
  /// Of `width` pixels in a row, `factor` x `factor` in a square.
  Shrinking(int width, int factor)
      : width_(width), factor_(factor), mean_of_sum_(255 * factor * factor + 1) {
    const int count = factor * factor;
    for (std::size_t sum = 0; sum < mean_of_sum_.size(); ++sum) {
      mean_of_sum_[sum] = static_cast<std::uint8_t>((sum + count / 2) / count);  // rounded
    }
  }

  /// One row of squares.
  void Shrink(const std::uint8_t* rgba, std::uint8_t* rgb) const {
    if (factor_ == 2) {
      ShrinkBy(std::integral_constant<int, 2>(), rgba, rgb);  // twice as fast
    } else {
      ShrinkBy(factor_, rgba, rgb);
    }
  }

 private:
  template <typename Int>
  void ShrinkBy(Int factor, const std::uint8_t* rgba, std::uint8_t* rgb) const {
    constexpr std::uint32_t kEvenBytes = 0x00ff00ff;
    for (int x = 0; x < width_; x += factor, rgb += 3) {
      std::uint32_t red_blue = 0;
      std::uint32_t green_alpha = 0;
      for (int dy = 0; dy < factor; ++dy) {
        const std::uint8_t* pixel =
            rgba + kNumChannels * (static_cast<std::size_t>(dy) * width_ + x);
        for (int dx = 0; dx < factor; ++dx, pixel += kNumChannels) {
          std::uint32_t word = 0;
          std::memcpy(&word, pixel, sizeof(word));
          red_blue += word & kEvenBytes;
          green_alpha += word >> 8 & kEvenBytes;
        }
      }
      rgb[0] = mean_of_sum_[red_blue & 0xffff];
      rgb[1] = mean_of_sum_[green_alpha & 0xffff];
      rgb[2] = mean_of_sum_[red_blue >> 16];
    }
  }

  int width_;
  int factor_;
  std::vector<std::uint8_t> mean_of_sum_;  // a division takes longer
};

}  // namespace

Painter::Painter(Backend backend) : window_(vtkSmartPointer<OffscreenWindow>::New()) {
  window_->Open(MakeGlContext(backend));
}

Picture Painter::Draw(const Scene& scene) {
  window_->SetSize(scene.width, scene.height);
  Show(scene, window_);
  window_->Render();
  const int factor = scene.oversampling;
  Picture picture{scene.width / factor, scene.height / factor, {}};
  const std::size_t row_size = 3 * static_cast<std::size_t>(picture.width);
  picture.rgb.resize(row_size * picture.height);
  const Shrinking shrinking(scene.width, factor);
  vtkNew<vtkUnsignedCharArray> rgba;
  for (int y = 0; y < picture.height; ++y) {  // from the lowest row up; a picture begins above
    window_->ReadRows(y * factor, factor, rgba);
    shrinking.Shrink(rgba->GetPointer(0), picture.rgb.data() + (picture.height - 1 - y) * row_size);
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
