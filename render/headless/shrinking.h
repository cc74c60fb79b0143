// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>

namespace loopscope {

/// RGBA is what OpenGL has, a byte each.
constexpr int kNumChannels = 4;

/// Averages squares of 2 x 2 pixels, rounded, to RGB, for whatever vectors the processor has.
/// `lower` and `upper` are two rows of 2 `width` pixels RGBA; `rgb` has room for `width`.
void ShrinkRows(const std::uint8_t* lower, const std::uint8_t* upper, std::size_t width,
                std::uint8_t* rgb);

/// Leaves out alpha.
void DropAlpha(const std::uint8_t* rgba, std::size_t width, std::uint8_t* rgb);

}  // namespace loopscope
