// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <cstring>

namespace loopscope {

/// The same bits as another type of this size.
template <typename To, typename From>
To BitCast(From from) {
  static_assert(sizeof(To) == sizeof(From));
  To to{};
  std::memcpy(&to, &from, sizeof(to));
  return to;
}

inline std::uint64_t BitsOf(double value) { return BitCast<std::uint64_t>(value); }
inline std::uint32_t BitsOf(float value) { return BitCast<std::uint32_t>(value); }
inline double DoubleOf(std::uint64_t bits) { return BitCast<double>(bits); }
inline float FloatOf(std::uint32_t bits) { return BitCast<float>(bits); }

}  // namespace loopscope
