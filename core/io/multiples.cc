// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/multiples.h"

#include <cmath>

#include "core/io/bits.h"

namespace loopscope {
namespace {

constexpr double kMaxMultiple = 0x1.0p+53;

}  // namespace

std::int64_t Multiple(double value, double scale) {
  const double multiple = std::round(value * scale);
  return std::abs(multiple) < kMaxMultiple ? static_cast<std::int64_t>(multiple) : 0;
}

double FromMultiple(std::int64_t multiple, double scale) {
  return static_cast<double>(multiple) / scale;
}

bool IsMultiple(double value, double scale) {
  return BitsOf(FromMultiple(Multiple(value, scale), scale)) == BitsOf(value);
}

std::int64_t GetMultiple(std::int64_t expected, ByteReader* in) {
  // Unsigned, so that damaged data may overflow.
  const auto multiple = static_cast<std::int64_t>(static_cast<std::uint64_t>(in->GetSigned()) +
                                                  static_cast<std::uint64_t>(expected));
  if (std::abs(static_cast<double>(multiple)) > kMaxMultiple) in->Fail("a number is too large");
  return multiple;
}

}  // namespace loopscope
