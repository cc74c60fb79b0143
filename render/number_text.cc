// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/number_text.h"

#include <cmath>

#include <fmt/format.h>

#include "core/geometry/pose2.h"

namespace loopscope {

std::string FixedText(double value, int digits) {
  const std::string text = fmt::format("{:.{}f}", value, digits);
  const bool is_nothing = text.find_first_not_of("-0.") == std::string::npos;
  return is_nothing && text.front() == '-' ? text.substr(1) : text;
}

std::string LengthText(double length) {
  return std::abs(length) < 1.0 ? FixedText(100.0 * length, 1) + " cm"
                                : FixedText(length, 2) + " m";
}

std::string CountText(double count) {
  return count < 1e6 ? FixedText(count, 0) : FixedText(1e-6 * count, 2) + " million";
}

std::string AngleText(double radians) { return FixedText(RadiansToDegrees(radians), 2) + "°"; }

}  // namespace loopscope
