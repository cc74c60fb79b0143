// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/no_return.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace loopscope {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kInvalid = std::numeric_limits<float>::quiet_NaN();

/// Calls change(scan, &reading) for every reading and notes how many it changed.
template <typename Change>
void ChangeReadings(const std::string& what, std::vector<CarmenRecord>* records, LogNotes* notes,
                    const Change& change) {
  for (CarmenRecord& record : *records) {
    if (!record.scan) continue;
    int num_changed = 0;
    for (float& reading : record.scan->readings) num_changed += change(*record.scan, &reading);
    if (num_changed > 0) notes->Add(what, record.line, num_changed);
  }
}

template <typename Visit>
void VisitReadings(const std::vector<CarmenRecord>& records, const Visit& visit) {
  for (const CarmenRecord& record : records) {
    if (!record.scan) continue;
    for (const float reading : record.scan->readings) visit(reading);
  }
}

bool IsCentimetreCode(float reading) { return reading >= 8183.f && reading <= 8191.f; }

bool IsInCentimetres(const std::vector<CarmenRecord>& records) {
  constexpr float kFarMedian = 40.f;  // farther than the median of any scan in metres
  bool has_code = false;
  long num_near = 0;
  long num_far = 0;
  VisitReadings(records, [&](float reading) {
    has_code = has_code || IsCentimetreCode(reading);
    num_near += reading > 0.f && reading < kFarMedian;
    num_far += reading >= kFarMedian && reading < 8183.f;
  });
  return has_code && num_far > num_near;
}

/// The largest range, if so many readings have it that it must stand for "nothing".
std::optional<float> PileAtEnd(const std::vector<CarmenRecord>& records) {
  constexpr float kShortestReach = 4.f;  // no scanner has a shorter one [m]
  constexpr long kMinPile = 100;
  float largest = 0.f;
  VisitReadings(records, [&](float reading) {
    if (std::isfinite(reading)) largest = std::max(largest, reading);
  });
  long num_finite = 0;
  long num_largest = 0;
  long num_just_below = 0;
  VisitReadings(records, [&](float reading) {
    num_finite += std::isfinite(reading);
    num_largest += reading == largest;
    num_just_below += reading < largest && reading > 0.95f * largest;
  });
  const bool piled = largest >= kShortestReach && num_largest >= kMinPile &&
                     100 * num_largest > num_finite && num_largest > num_just_below &&
                     5 * num_largest < 4 * num_finite;
  return piled ? std::make_optional(largest) : std::nullopt;
}

}  // namespace

bool IsNoReturnCode(float reading) {
  const auto within = [reading](double low, double high) {
    constexpr double kHalfCentimetre = 0.005;
    return reading > low - kHalfCentimetre && reading < high + kHalfCentimetre;
  };
  return within(81.83, 81.91) || within(51.0, 51.19) || reading == 50.f || within(32.77, 32.77) ||
         IsCentimetreCode(reading);
}

void CleanReadings(double max_range, std::vector<CarmenRecord>* records, LogNotes* notes) {
  if (IsInCentimetres(*records)) {
    ChangeReadings("readings in centimetres, converted", records, notes,
                   [](const CarmenScan&, float* reading) {
                     *reading = static_cast<float>(static_cast<double>(*reading) / 100.0);
                     return true;
                   });
  }
  ChangeReadings("readings that are no number or not above zero", records, notes,
                 [](const CarmenScan&, float* reading) {
                   if (*reading > 0.f) return false;
                   *reading = kInvalid;
                   return true;
                 });
  ChangeReadings("readings that mean that nothing came back", records, notes,
                 [max_range](const CarmenScan& scan, float* reading) {
                   if (!IsNoReturnCode(*reading) && !(*reading >= max_range) &&
                       !(*reading >= scan.max_range)) {
                     return false;
                   }
                   *reading = kInfinity;
                   return true;
                 });
  if (const std::optional<float> pile = PileAtEnd(*records)) {
    ChangeReadings(
        fmt::format("readings of {:g} m, the largest and too frequent: no return", *pile), records,
        notes, [pile](const CarmenScan&, float* reading) {
          if (*reading != *pile) return false;
          *reading = kInfinity;
          return true;
        });
  }
}

}  // namespace loopscope
