// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/session/table.h"

namespace loopscope {

struct FilterTerm;

/// Which rows of a table to show, said in one line:
///   score > 0.6 and residual > 0.2     < <= > >= = != with a number (without its unit)
///   score 0.5..0.7                     from 0.5 to 0.7, both included
///   verdict = closed or node = 12      `and` before `or`; `not`; parentheses
///   verdict != "not sampled"           a whole text; quotes around more than one word
///   closed 'other place'               texts that occur in any column of text; side by side: `and`
/// Columns go by name or the beginning of one, if only one begins like that. Letters are compared
/// without case. Equal numbers differ by half of the last digit shown at most. What compares a
/// value that is not known is false, so that `not` of it is true.
class TableFilter {
 public:
  /// Lets all rows through.
  TableFilter() = default;

  /// Parses `text` for tables with these columns; if it is blank, all rows go through. Throws
  /// std::invalid_argument that says what was expected at which position, counted from 1.
  TableFilter(const std::string& text, const std::vector<Column>& columns);

  /// One entry a row of `table`, which has the columns that the filter was made for: 1 if the row
  /// goes through, else 0.
  std::vector<char> Matches(const Table& table) const;

 private:
  std::shared_ptr<const FilterTerm> root_;  ///< null: all rows
};

/// The rows that go through `filter`, in the order of the table, or sorted by a column as
/// Table::Compare has it. Rows that are alike keep their order, and those in which the column is
/// not known come last, descending or not.
std::vector<int> RowsOf(const Table& table, const TableFilter& filter,
                        std::optional<int> sort_column = std::nullopt, bool descending = false);

}  // namespace loopscope
