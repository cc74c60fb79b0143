// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/headless/blending.h"

#include <algorithm>

// Highway compiles the functions between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each
// instruction set, and chooses when the program runs.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/headless/blending.cc"
#include <hwy/foreach_target.h>
// Must come after it.
#include <hwy/highway.h>

static_assert(sizeof(loopscope::Color) == 4, "pixels are read as they are");

HWY_BEFORE_NAMESPACE();
namespace loopscope::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// A share of `value`, in 255ths, rounded.
int ShareOf(int value, int share) { return (2 * value * share + 255) / (2 * 255); }

void BlendRowHere(const std::uint8_t* over, const std::uint8_t* ground, std::size_t num_bytes,
                  std::uint8_t* blended) {
  std::size_t i = 0;
#if HWY_TARGET != HWY_SCALAR
  const hn::ScalableTag<std::uint8_t> bytes;
  const hn::Repartition<std::uint16_t, decltype(bytes)> words;
  HWY_ALIGN static constexpr std::uint8_t kAlphas[16] = {3,  3,  3,  3,  7,  7,  7,  7,
                                                         11, 11, 11, 11, 15, 15, 15, 15};
  const auto alphas = hn::LoadDup128(bytes, kAlphas);
  const auto lower = hn::Set(words, 0xff);  // byte of each word
  for (; i + hn::Lanes(bytes) <= num_bytes; i += hn::Lanes(bytes)) {
    const auto color = hn::LoadU(bytes, over + i);
    const auto ground_color = hn::LoadU(bytes, ground + i);
    if (hn::AllTrue(bytes, hn::Eq(color, hn::Zero(bytes)))) {
      hn::StoreU(ground_color, bytes, blended + i);
      continue;
    }
    const auto clear = hn::Not(hn::TableLookupBytes(color, alphas));  // 255 - alpha
    const auto share = hn::And(hn::BitCast(words, clear), lower);
    const auto beneath = hn::BitCast(words, ground_color);
    const auto shares_of = [&](auto values) HWY_ATTR {
      const auto product = hn::Add(hn::Mul(values, share), hn::Set(words, 128));
      return hn::ShiftRight<8>(hn::Add(product, hn::ShiftRight<8>(product)));
    };
    const auto even = shares_of(hn::And(beneath, lower));
    const auto odd = shares_of(hn::ShiftRight<8>(beneath));
    const auto rest = hn::BitCast(bytes, hn::Or(even, hn::ShiftLeft<8>(odd)));
    hn::StoreU(hn::SaturatedAdd(color, rest), bytes, blended + i);
  }
#endif
  for (; i < num_bytes; ++i) {
    const int alpha = over[i - i % 4 + 3];
    const int sum = over[i] + ShareOf(ground[i], 255 - alpha);
    blended[i] = static_cast<std::uint8_t>(std::min(255, sum));
  }
}

}  // namespace loopscope::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace loopscope {

HWY_EXPORT(BlendRowHere);

void BlendRow(const Color* over, const Color* ground, std::size_t num_pixels, Color* blended) {
  HWY_DYNAMIC_DISPATCH(BlendRowHere)
  (reinterpret_cast<const std::uint8_t*>(over), reinterpret_cast<const std::uint8_t*>(ground),
   sizeof(Color) * num_pixels, reinterpret_cast<std::uint8_t*>(blended));
}

}  // namespace loopscope
#endif
