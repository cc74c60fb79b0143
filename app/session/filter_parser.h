// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "app/session/table.h"

namespace loopscope {

/// A node of the syntax tree of a TableFilter.
struct FilterTerm {
  enum class Kind {
    kAnd,      ///< all parts
    kOr,       ///< any of the parts
    kNot,      ///< of the one part
    kNumber,   ///< `column` lies in the interval
    kText,     ///< `column` is `text`
    kAnyText,  ///< `text` occurs in a column of text
  };

  /// Numbers from `low` to `high`.
  struct Interval {
    double low = 0.0;
    double high = 0.0;
    bool with_low = true;
    bool with_high = true;

    bool Contains(double number) const {
      return (with_low ? number >= low : number > low) &&
             (with_high ? number <= high : number < high);
    }
  };

  Kind kind = Kind::kAnyText;
  std::vector<std::shared_ptr<const FilterTerm>> parts;
  int column = 0;
  bool negated = false;  ///< known values that do not match, for `!=`
  Interval interval;
  std::string text;  ///< in lower case
};

/// Of ASCII letters.
std::string ToLowerCase(std::string text);

/// Parses a filter that is not blank. Throws as TableFilter does.
std::shared_ptr<const FilterTerm> ParseFilter(const std::string& text,
                                              const std::vector<Column>& columns);

}  // namespace loopscope
