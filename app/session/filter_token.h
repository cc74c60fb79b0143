// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace loopscope {

/// A word of a filter.
struct FilterToken {
  enum class Kind { kWord, kQuoted, kComparison, kOpen, kClose, kEnd };

  Kind kind = Kind::kEnd;
  std::string text;  ///< as written; of what was quoted, without the quotes
  int position = 0;  ///< where it begins, counted from 1
};

/// The words of a filter, the last of which is kEnd. Throws std::invalid_argument if a quote is not
/// closed.
std::vector<FilterToken> FilterTokens(const std::string& text);

/// What is wrong at a position of a filter, and what was expected.
std::invalid_argument FilterError(int position, const std::string& what);

}  // namespace loopscope
