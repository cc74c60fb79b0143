// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <unordered_map>
#include <variant>
#include <vector>

namespace loopscope {

struct Column {
  enum class Kind { kNumber, kText };

  std::string name;  ///< one word in lower case, e.g. "min_score"
  std::string unit;  ///< "m", "deg", "s"; empty for a pure number and for text
  Kind kind = Kind::kNumber;
  int digits = 0;    ///< behind the point, in what is shown
  std::string help;  ///< one sentence
};

/// A value of a table; monostate: not known.
using Cell = std::variant<std::monostate, double, std::string>;

/// Named columns of numbers or text, stored by column: a number takes 8 bytes, a text that is there
/// already takes 4.
class Table {
 public:
  explicit Table(std::vector<Column> columns);

  const std::vector<Column>& columns() const { return columns_; }
  int num_columns() const { return static_cast<int>(columns_.size()); }
  int num_rows() const { return num_rows_; }

  /// Index of the column of this very name. Throws std::invalid_argument that names all columns if
  /// there is none.
  int ColumnOf(const std::string& name) const;

  /// Adds rows at the end in which nothing is known yet.
  void AddRows(int num_rows);

  /// `value` is of the kind of the column, or monostate.
  void Set(int row, int column, const Cell& value);

  Cell At(int row, int column) const;
  bool IsKnown(int row, int column) const;

  /// The value as it is shown, without its unit; empty if it is not known.
  std::string Text(int row, int column) const;

  /// Less than 0, 0 or more than 0, as row `a` comes before, with or after row `b` in ascending
  /// order: numbers by value, text by its bytes, what is not known last.
  int Compare(int column, int a, int b) const;

  // Whole columns, for those who must be fast.

  /// Of a column of numbers, one a row; NaN: not known.
  const std::vector<double>& Numbers(int column) const { return stores_[column].numbers; }
  /// Of a column of text, one a row: index into its Words, or -1: not known.
  const std::vector<int>& WordIds(int column) const { return stores_[column].word_ids; }
  /// The different texts of a column, in the order in which they came.
  const std::vector<std::string>& Words(int column) const { return stores_[column].words; }

 private:
  struct Store {
    std::vector<double> numbers;
    std::vector<int> word_ids;
    std::vector<std::string> words;
    std::unordered_map<std::string, int> id_of_word;
  };

  int IdOf(const std::string& word, Store* store);

  std::vector<Column> columns_;
  std::vector<Store> stores_;  ///< one a column; only what its kind needs is used
  int num_rows_ = 0;
};

}  // namespace loopscope
