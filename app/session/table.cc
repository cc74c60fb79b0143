// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "render/number_text.h"

namespace loopscope {
namespace {

constexpr double kUnknownNumber = std::numeric_limits<double>::quiet_NaN();
constexpr int kUnknownWord = -1;

/// `is_known` of two values, of which `compare` is asked only if both are.
template <typename Comparison>
int UnknownLast(bool a_is_known, bool b_is_known, const Comparison& compare) {
  if (a_is_known && b_is_known) return compare();
  return static_cast<int>(b_is_known) - static_cast<int>(a_is_known);
}

}  // namespace

Table::Table(std::vector<Column> columns)
    : columns_(std::move(columns)), stores_(columns_.size()) {}

int Table::ColumnOf(const std::string& name) const {
  std::string names;
  for (int i = 0; i < num_columns(); ++i) {
    if (columns_[i].name == name) return i;
    names += (i == 0 ? "" : ", ") + columns_[i].name;
  }
  throw std::invalid_argument("no column '" + name + "': expected one of " + names);
}

void Table::AddRows(int num_rows) {
  num_rows_ += num_rows;
  for (int i = 0; i < num_columns(); ++i) {
    if (columns_[i].kind == Column::Kind::kNumber) {
      stores_[i].numbers.resize(num_rows_, kUnknownNumber);
    } else {
      stores_[i].word_ids.resize(num_rows_, kUnknownWord);
    }
  }
}

void Table::Set(int row, int column, const Cell& value) {
  Store& store = stores_[column];
  if (columns_[column].kind == Column::Kind::kNumber) {
    assert(!std::holds_alternative<std::string>(value));
    const double* const number = std::get_if<double>(&value);
    store.numbers[row] = number == nullptr ? kUnknownNumber : *number;
  } else {
    assert(!std::holds_alternative<double>(value));
    const std::string* const word = std::get_if<std::string>(&value);
    store.word_ids[row] = word == nullptr ? kUnknownWord : IdOf(*word, &store);
  }
}

int Table::IdOf(const std::string& word, Store* store) {
  const auto [found, is_new] =
      store->id_of_word.emplace(word, static_cast<int>(store->words.size()));
  if (is_new) store->words.push_back(word);
  return found->second;
}

Cell Table::At(int row, int column) const {
  if (!IsKnown(row, column)) return std::monostate();
  const Store& store = stores_[column];
  if (columns_[column].kind == Column::Kind::kNumber) return store.numbers[row];
  return store.words[store.word_ids[row]];
}

bool Table::IsKnown(int row, int column) const {
  const Store& store = stores_[column];
  return columns_[column].kind == Column::Kind::kNumber ? !std::isnan(store.numbers[row])
                                                        : store.word_ids[row] != kUnknownWord;
}

std::string Table::Text(int row, int column) const {
  if (!IsKnown(row, column)) return "";
  const Store& store = stores_[column];
  return columns_[column].kind == Column::Kind::kNumber
             ? FixedText(store.numbers[row], columns_[column].digits)
             : store.words[store.word_ids[row]];
}

int Table::Compare(int column, int a, int b) const {
  return UnknownLast(IsKnown(a, column), IsKnown(b, column), [&] {
    const Store& store = stores_[column];
    if (columns_[column].kind == Column::Kind::kText) {
      return store.words[store.word_ids[a]].compare(store.words[store.word_ids[b]]);
    }
    const double x = store.numbers[a];
    const double y = store.numbers[b];
    return static_cast<int>(x > y) - static_cast<int>(x < y);
  });
}

}  // namespace loopscope
