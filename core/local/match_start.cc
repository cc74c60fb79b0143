// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/match_start.h"

namespace loopscope {

std::string ToString(MatchStart start) {
  switch (start) {
    case MatchStart::kNone:
      return "nowhere: not matched";
    case MatchStart::kPrior:
      return "where predicted";
    case MatchStart::kVelocity:
      return "by the velocity";
    case MatchStart::kRecovery:
      return "by a wide search";
    case MatchStart::kAhead:
      return "nowhere: led by scans ahead";
    case MatchStart::kMotions:
      return "nowhere: led by motions before";
  }
  return "";
}

}  // namespace loopscope
