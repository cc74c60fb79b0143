// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/number_rows.h"

#include <cmath>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "core/io/file_error.h"
#include "core/io/line_reader.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

constexpr std::size_t kMaxRows = 10'000'000;
constexpr double kMaxNumber = 1e100;  // its square is a number, too

std::optional<NumberRow> ParseRow(const std::vector<std::string_view>& words) {
  NumberRow row;
  if (words.size() != row.size()) return std::nullopt;
  for (std::size_t i = 0; i < row.size(); ++i) {
    const std::optional<double> number = ParseDouble(words[i]);
    if (!number || !(std::abs(*number) <= kMaxNumber)) return std::nullopt;
    row[i] = *number;
  }
  return row;
}

}  // namespace

std::vector<NumberRow> ReadNumberRows(const std::string& path, const std::string& columns,
                                      const std::optional<RowCondition>& condition) {
  std::vector<NumberRow> rows;
  std::vector<std::string_view> words;
  LineReader lines(path);
  while (const auto line = lines.Next()) {
    SplitWords(*line, &words);
    if (words.empty() || words.front().front() == '#') continue;
    const std::optional<NumberRow> row = ParseRow(words);
    if (!row || rows.size() == kMaxRows) {
      throw FileError(path, lines.line_number(),
                      row ? fmt::format("too long; expected at most {} lines", kMaxRows)
                          : fmt::format("expected eight numbers, \"{}\"", columns));
    }
    if (condition && !condition->holds(*row)) {
      throw FileError(path, lines.line_number(), "expected " + condition->what);
    }
    rows.push_back(*row);
  }
  if (rows.empty()) throw FileError(path, fmt::format("empty; expected lines \"{}\"", columns));
  return rows;
}

}  // namespace loopscope
