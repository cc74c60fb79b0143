// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace loopscope {

/// The parts of `line` between spaces, tabs and carriage returns. They point into it.
void SplitWords(std::string_view line, std::vector<std::string_view>* words);

/// The number that is written in `word`, and nothing else in it. "nan" and "inf" are numbers; what
/// no double can hold is none. Does not depend on the locale.
std::optional<double> ParseDouble(std::string_view word);

std::optional<int> ParseInt(std::string_view word);

}  // namespace loopscope
