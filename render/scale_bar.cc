// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scale_bar.h"

#include <cmath>

#include <fmt/format.h>

namespace loopscope {

double RoundLength(double max_length) {
  constexpr double kRoundingSlack = 1.0 + 1e-9;
  const double power = std::pow(10.0, std::floor(std::log10(max_length * kRoundingSlack)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= max_length * kRoundingSlack) return factor * power;
  }
  return power;
}

std::string LengthLabel(double length) {
  if (length < 0.00999) return fmt::format("{:g} mm", length * 1e3);
  if (length < 0.999) return fmt::format("{:g} cm", length * 1e2);
  if (length < 999.0) return fmt::format("{:g} m", length);
  return fmt::format("{:g} km", length * 1e-3);
}

}  // namespace loopscope
