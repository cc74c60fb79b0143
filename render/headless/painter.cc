// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/painter.h"

#include <algorithm>
#include <vector>
#include <vtkNew.h>
#include <vtkUnsignedCharArray.h>

namespace loopscope {
namespace {

constexpr int kNumChannels = 4;  // RGBA is what OpenGL has

/// Averages squares of pixels, RGBA to RGB.
class Shrinking {
 public:
  /// Of `width` pixels in a row, `factor` x `factor` in a square.
  Shrinking(int width, int factor)
      : row_size_(kNumChannels * static_cast<std::size_t>(width)),
        factor_(factor),
        sums_(row_size_),
        mean_of_sum_(255 * factor * factor + 1) {
    const int count = factor * factor;
    for (std::size_t sum = 0; sum < mean_of_sum_.size(); ++sum) {
      mean_of_sum_[sum] = static_cast<std::uint8_t>((sum + count / 2) / count);  // rounded
    }
  }

  /// One row of squares.
  void Shrink(const std::uint8_t* rgba, std::uint8_t* rgb) {
    std::copy_n(rgba, row_size_, sums_.begin());
    for (int dy = 1; dy < factor_; ++dy) {
      const std::uint8_t* const row = rgba + dy * row_size_;
      for (std::size_t i = 0; i < row_size_; ++i) sums_[i] += row[i];
    }
    const std::size_t square = kNumChannels * factor_;
    for (std::size_t i = 0; i < row_size_; i += square) {
      int red = 0;
      int green = 0;
      int blue = 0;
      for (std::size_t j = i; j < i + square; j += kNumChannels) {
        red += sums_[j];
        green += sums_[j + 1];
        blue += sums_[j + 2];
      }
      *rgb++ = mean_of_sum_[red];
      *rgb++ = mean_of_sum_[green];
      *rgb++ = mean_of_sum_[blue];
    }
  }

 private:
  std::size_t row_size_;
  int factor_;
  std::vector<std::uint16_t> sums_;        // of the rows of squares, RGBA
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
  Shrinking shrinking(scene.width, factor);
  vtkNew<vtkUnsignedCharArray> rgba;
  for (int y = 0; y < picture.height; ++y) {  // from the lowest row up; a picture begins above
    window_->ReadRows(y * factor, factor, rgba);
    shrinking.Shrink(rgba->GetPointer(0),
                     picture.rgb.data() + (picture.height - 1 - y) * row_size);
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
