// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <random>

namespace loopscope {

/// Random numbers that are the same for the same seed with every standard library: the engine is
/// fixed by the standard, the distributions (which are not) are our own.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  /// Uniform in [0, 1).
  double Uniform();

  /// Uniform in [low, high).
  double Uniform(double low, double high);

  /// Normal with mean 0 and standard deviation `sigma` >= 0 (Box and Muller 1958).
  double Gaussian(double sigma);

  /// Uniform in {0, ..., count - 1}.
  int Below(int count);

 private:
  std::mt19937_64 engine_;
};

}  // namespace loopscope
