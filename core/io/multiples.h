// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/io/byte_stream.h"

namespace loopscope {

// Numbers that are whole multiples of 1 / scale, as are those that once were text or were rounded.

/// round(value * scale), or 0 if that is nothing that an integer can hold.
std::int64_t Multiple(double value, double scale);
double FromMultiple(std::int64_t multiple, double scale);

/// Whether FromMultiple gives `value` back, bit for bit.
bool IsMultiple(double value, double scale);

/// The multiple that was put as its difference from `expected`. Fails if it is too large to be one,
/// as it may be in damaged data.
std::int64_t GetMultiple(std::int64_t expected, ByteReader* in);

}  // namespace loopscope
