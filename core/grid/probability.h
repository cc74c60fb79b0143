// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

namespace loopscope {

/// Occupancy is kept in 16 bits: 0 is a cell never observed, 1 ... 32767 are probabilities from
/// kMinProbability to kMaxProbability in even steps.
using CellValue = std::uint16_t;

constexpr CellValue kUnknown = 0;
constexpr CellValue kMaxCellValue = 32767;
constexpr double kMinProbability = 0.1;
constexpr double kMaxProbability = 0.9;

/// odds(p) = p / (1 - p), eq. 2.
inline double Odds(double probability) { return probability / (1.0 - probability); }
inline double ProbabilityFromOdds(double odds) { return odds / (odds + 1.0); }

/// From one value to the next.
constexpr double kProbabilityStep = (kMaxProbability - kMinProbability) / (kMaxCellValue - 1);

/// How many steps `value` is above kMinProbability, which is also what an unknown cell counts as in
/// matching.
constexpr int StepsAboveMin(CellValue value) { return value - (value == kUnknown ? 0 : 1); }

/// `value` must not be kUnknown.
inline double ProbabilityOf(CellValue value) {
  return kMinProbability + (value - 1) * kProbabilityStep;
}

/// The nearest value to `probability`, which is clamped to [kMinProbability, kMaxProbability].
CellValue ToCellValue(double probability);

/// The update of eq. 3 as a table: entry v is what an observation of probability p makes of a cell
/// of value v: clamp(odds^-1(odds(M_old) * odds(p))), and p itself for an unknown cell.
class OddsUpdate {
 public:
  explicit OddsUpdate(double probability);

  CellValue operator()(CellValue value) const { return table_[value]; }

 private:
  std::vector<CellValue> table_;
};

}  // namespace loopscope
