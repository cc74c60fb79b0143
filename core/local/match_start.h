// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// Where the match of a scan began that was believed.
enum class MatchStart {
  kNone,      ///< it was not matched, or matched nowhere as expected: it stays where odometry has
              ///< it, or without where the scan before was
  kPrior,     ///< where odometry has the robot, or without odometry the velocity
  kVelocity,  ///< where the robot would be had it gone on as before: odometry was not believed
  kRecovery,  ///< where a search in a wide window found it, or one by the motions before
  kAhead,     ///< nowhere, but a scan soon after it did match: it has its share of the jump there
  kMotions,   ///< nowhere: where the motions before have it, for odometry is missing or doubted
};

/// Whether only what was expected tells how the robot came there.
constexpr bool MatchedNowhere(MatchStart start) {
  return start == MatchStart::kNone || start == MatchStart::kAhead || start == MatchStart::kMotions;
}

/// In a few words, such as "by the velocity".
std::string ToString(MatchStart start);

}  // namespace loopscope
