// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/table_filter.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "app/session/filter_parser.h"

namespace loopscope {
namespace {

using Rows = std::vector<char>;  ///< 1 for a row that matches, else 0

Rows Evaluate(const FilterTerm& term, const Table& table);

Rows EvaluateNumber(const FilterTerm& term, const Table& table) {
  Rows rows(table.num_rows());
  const std::vector<double>& numbers = table.Numbers(term.column);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const bool is_known = !std::isnan(numbers[i]);
    rows[i] = is_known && term.interval.Contains(numbers[i]) != term.negated ? 1 : 0;
  }
  return rows;
}

/// Sets the rows whose text in `column` is one that `matches`; every different text is asked for
/// once.
template <typename Predicate>
void AddMatches(const Table& table, int column, const Predicate& matches, Rows* rows) {
  std::vector<char> word_matches;
  for (const std::string& word : table.Words(column)) {
    word_matches.push_back(matches(ToLowerCase(word)) ? 1 : 0);
  }
  const std::vector<int>& ids = table.WordIds(column);
  for (std::size_t i = 0; i < rows->size(); ++i) {
    if (ids[i] >= 0) (*rows)[i] |= word_matches[ids[i]];
  }
}

Rows EvaluateText(const FilterTerm& term, const Table& table) {
  Rows rows(table.num_rows(), 0);
  AddMatches(
      table, term.column,
      [&](const std::string& word) { return (word == term.text) != term.negated; }, &rows);
  return rows;
}

Rows EvaluateAnyText(const FilterTerm& term, const Table& table) {
  Rows rows(table.num_rows(), 0);
  for (int column = 0; column < table.num_columns(); ++column) {
    if (table.columns()[column].kind != Column::Kind::kText) continue;
    AddMatches(
        table, column,
        [&](const std::string& word) { return word.find(term.text) != std::string::npos; }, &rows);
  }
  return rows;
}

Rows EvaluateParts(const FilterTerm& term, const Table& table) {
  Rows rows = Evaluate(*term.parts[0], table);
  for (std::size_t part = 1; part < term.parts.size(); ++part) {
    const Rows others = Evaluate(*term.parts[part], table);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = term.kind == FilterTerm::Kind::kAnd ? rows[i] & others[i] : rows[i] | others[i];
    }
  }
  return rows;
}

Rows Evaluate(const FilterTerm& term, const Table& table) {
  switch (term.kind) {
    case FilterTerm::Kind::kNumber:
      return EvaluateNumber(term, table);
    case FilterTerm::Kind::kText:
      return EvaluateText(term, table);
    case FilterTerm::Kind::kAnyText:
      return EvaluateAnyText(term, table);
    case FilterTerm::Kind::kAnd:
    case FilterTerm::Kind::kOr:
      return EvaluateParts(term, table);
    case FilterTerm::Kind::kNot:
      break;
  }
  Rows rows = Evaluate(*term.parts[0], table);
  for (char& row : rows) row = static_cast<char>(1 - row);
  return rows;
}

/// Numbers that sort as the texts of a column do; NaN: not known.
std::vector<double> RanksOfTexts(const Table& table, int column) {
  const std::vector<std::string>& words = table.Words(column);
  std::vector<int> order(words.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) { return words[a] < words[b]; });
  std::vector<double> rank_of_word(words.size());
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    rank_of_word[order[rank]] = static_cast<double>(rank);
  }
  std::vector<double> ranks;
  ranks.reserve(table.num_rows());
  for (const int id : table.WordIds(column)) {
    ranks.push_back(id < 0 ? std::numeric_limits<double>::quiet_NaN() : rank_of_word[id]);
  }
  return ranks;
}

void Sort(const Table& table, int column, bool descending, std::vector<int>* rows) {
  const std::vector<double> keys = table.columns()[column].kind == Column::Kind::kNumber
                                       ? table.Numbers(column)
                                       : RanksOfTexts(table, column);
  const auto known_end = std::stable_partition(rows->begin(), rows->end(),
                                               [&](int row) { return !std::isnan(keys[row]); });
  std::stable_sort(rows->begin(), known_end, [&](int a, int b) {
    return descending ? keys[a] > keys[b] : keys[a] < keys[b];
  });
}

}  // namespace

TableFilter::TableFilter(const std::string& text, const std::vector<Column>& columns)
    : root_(text.find_first_not_of(" \t\r\n") == std::string::npos ? nullptr
                                                                   : ParseFilter(text, columns)) {}

std::vector<char> TableFilter::Matches(const Table& table) const {
  return root_ == nullptr ? Rows(table.num_rows(), 1) : Evaluate(*root_, table);
}

std::vector<int> RowsOf(const Table& table, const TableFilter& filter,
                        std::optional<int> sort_column, bool descending) {
  const std::vector<char> matches = filter.Matches(table);
  std::vector<int> rows;
  for (int row = 0; row < table.num_rows(); ++row) {
    if (matches[row] != 0) rows.push_back(row);
  }
  if (sort_column) Sort(table, *sort_column, descending, &rows);
  return rows;
}

}  // namespace loopscope
