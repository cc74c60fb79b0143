// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include "app/session/command_groups.h"

namespace loopscope {
namespace {

/// A change of the table that the first word of the argument names; the rest is for `change`.
Command TableCommand(const char* name, const char* title, const char* argument,
                     void (*change)(const std::string& rest, TableSettings* settings)) {
  return StateCommand({name, title, "", {}, argument, Always, {}},
                      [change](const Session&, const std::string& text, SessionState* state) {
                        const std::size_t space = std::min(text.find(' '), text.size());
                        const TableKind kind = TableKindFromName(text.substr(0, space));
                        change(text.substr(std::min(space + 1, text.size())), &state->tables[kind]);
                      });
}

void SortBy(const std::string& column, TableSettings* settings) {
  settings->sort_by = column;
  settings->descending = false;
}

void SortDownBy(const std::string& column, TableSettings* settings) {
  settings->sort_by = column;
  settings->descending = true;
}

}  // namespace

std::vector<Command> ListCommands() {
  return {
      TableCommand(
          "table.filter", "List only rows that fit", "TABLE QUERY",
          [](const std::string& rest, TableSettings* settings) { settings->filter = rest; }),
      TableCommand("table.sort", "Sort rows, lowest first", "TABLE COLUMN", SortBy),
      TableCommand("table.sort_down", "Sort rows, highest first", "TABLE COLUMN", SortDownBy),
  };
}

}  // namespace loopscope
