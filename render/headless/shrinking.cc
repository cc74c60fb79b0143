// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/shrinking.h"

#include <algorithm>
#include <cstring>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/headless/shrinking.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// Averages 2 x 2 pixels to one, RGBA.
void ShrinkRowsHere(const std::uint8_t* lower, const std::uint8_t* upper, std::size_t width,
                    std::uint8_t* rgba) {
  std::size_t byte = 0;  // of `rgba`
#if HWY_TARGET != HWY_SCALAR
  const hn::ScalableTag<std::uint8_t> bytes;
  const hn::Repartition<std::uint16_t, decltype(bytes)> sums;
  const hn::Repartition<std::uint64_t, decltype(bytes)> pixels;  // of sums
  const hn::Repartition<std::int16_t, decltype(bytes)> means;
  const auto zero = hn::Zero(bytes);
  const std::size_t step = hn::Lanes(bytes) / 2;
  for (; byte + step <= kNumChannels * width; byte += step) {
    const auto below = hn::LoadU(bytes, lower + 2 * byte);
    const auto above = hn::LoadU(bytes, upper + 2 * byte);
    // Of each four pixels in a row the first two, and the last two.
    const auto first =
        hn::BitCast(pixels, hn::Add(hn::BitCast(sums, hn::InterleaveLower(bytes, below, zero)),
                                    hn::BitCast(sums, hn::InterleaveLower(bytes, above, zero))));
    const auto last =
        hn::BitCast(pixels, hn::Add(hn::BitCast(sums, hn::InterleaveUpper(bytes, below, zero)),
                                    hn::BitCast(sums, hn::InterleaveUpper(bytes, above, zero))));
    const auto all = hn::Add(hn::BitCast(sums, hn::InterleaveLower(pixels, first, last)),
                             hn::BitCast(sums, hn::InterleaveUpper(pixels, first, last)));
    const auto mean = hn::BitCast(means, hn::ShiftRight<2>(hn::Add(all, hn::Set(sums, 2))));
    const hn::Rebind<std::uint8_t, decltype(means)> half;
    hn::StoreU(hn::DemoteTo(half, mean), half, rgba + byte);
  }
#endif
  for (; byte < kNumChannels * width; ++byte) {
    const std::size_t left = 2 * byte - byte % kNumChannels;
    const std::size_t right = left + kNumChannels;
    rgba[byte] = static_cast<std::uint8_t>(
        (lower[left] + lower[right] + upper[left] + upper[right] + 2) / 4);
  }
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

HWY_EXPORT(ShrinkRowsHere);

void ShrinkRows(const std::uint8_t* lower, const std::uint8_t* upper, std::size_t width,
                std::uint8_t* rgb) {
  constexpr std::size_t kMaxWidth = 256;  // at once
  std::uint8_t rgba[kNumChannels * kMaxWidth];
  for (std::size_t x = 0; x < width; x += kMaxWidth) {
    const std::size_t count = std::min(kMaxWidth, width - x);
    const std::size_t begin = 2 * kNumChannels * x;
    HWY_DYNAMIC_DISPATCH(ShrinkRowsHere)(lower + begin, upper + begin, count, rgba);
    DropAlpha(rgba, count, rgb + 3 * x);
  }
}

void DropAlpha(const std::uint8_t* rgba, std::size_t width, std::uint8_t* rgb) {
  for (std::size_t x = 0; x + 1 < width; ++x) {
    std::memcpy(rgb + 3 * x, rgba + kNumChannels * x, kNumChannels);  // the next goes over alpha
  }
  if (width > 0) std::memcpy(rgb + 3 * (width - 1), rgba + kNumChannels * (width - 1), 3);
}

}  // namespace loopscope
#endif
