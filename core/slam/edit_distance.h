// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// Number of letters to insert, drop or replace to turn `a` into `b` (Levenshtein 1966).
int EditDistance(const std::string& a, const std::string& b);

}  // namespace loopscope
