// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

// Numbers as people read them.

/// `value` with so many digits behind the point; what rounds to nothing has no sign.
std::string FixedText(double value, int digits);

/// "12.3 cm" or "4.56 m"; `length` in [m].
std::string LengthText(double length);

/// "40817" or "8.45 million".
std::string CountText(double count);

/// "0.41°"; `radians` in any range.
std::string AngleText(double radians);

}  // namespace loopscope
