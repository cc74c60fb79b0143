// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/probability.h"

#include <algorithm>
#include <cmath>

namespace loopscope {

CellValue ToCellValue(double probability) {
  const double clamped = std::clamp(probability, kMinProbability, kMaxProbability);
  const double steps =
      (clamped - kMinProbability) * (kMaxCellValue - 1) / (kMaxProbability - kMinProbability);
  return static_cast<CellValue>(1 + std::lround(steps));
}

OddsUpdate::OddsUpdate(double probability) : table_(kMaxCellValue + 1) {
  table_[kUnknown] = ToCellValue(probability);
  const double odds = Odds(probability);
  for (int value = 1; value <= kMaxCellValue; ++value) {
    const double old_odds = Odds(ProbabilityOf(static_cast<CellValue>(value)));
    table_[value] = ToCellValue(ProbabilityFromOdds(old_odds * odds));
  }
}

}  // namespace loopscope
