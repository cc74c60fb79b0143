// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// The longest of 1, 2 and 5 times a power of ten that is not above `max_length` > 0 [m].
double RoundLength(double max_length);

/// "20 cm", "5 m", "2 km": a round length [m] in the unit that needs no zeros.
std::string LengthLabel(double length);

}  // namespace loopscope
