// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/simulation/random.h"

#include <cassert>
#include <cmath>

namespace loopscope {

double Random::Uniform() {
  constexpr double kTwoToMinus53 = 1.0 / 9007199254740992.0;
  return static_cast<double>(engine_() >> 11) * kTwoToMinus53;
}

double Random::Uniform(double low, double high) { return low + (high - low) * Uniform(); }

double Random::Gaussian(double sigma) {
  constexpr double kTwoPi = 6.283185307179586;
  const double radius = std::sqrt(-2.0 * std::log(1.0 - Uniform()));
  return sigma * radius * std::cos(kTwoPi * Uniform());
}

int Random::Below(int count) {
  assert(count > 0);
  return static_cast<int>(Uniform() * count);
}

}  // namespace loopscope
