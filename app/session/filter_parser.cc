// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/filter_parser.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "app/session/filter_token.h"
#include "core/io/words.h"
#include "core/slam/edit_distance.h"

namespace loopscope {
namespace {

using TokenKind = FilterToken::Kind;
using TermKind = FilterTerm::Kind;
using TermPointer = std::shared_ptr<const FilterTerm>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMaxDepth = 100;  ///< of parentheses and nots

bool IsKeyword(const FilterToken& token, const char* keyword) {
  return token.kind == TokenKind::kWord && ToLowerCase(token.text) == keyword;
}

std::optional<double> FiniteNumber(const std::string& text) {
  const std::optional<double> number = ParseDouble(text);
  return number && std::isfinite(*number) ? number : std::nullopt;
}

bool LooksLikeRange(const FilterToken& token) {
  return token.kind == TokenKind::kWord && token.text.find("..") != std::string::npos &&
         (std::isdigit(static_cast<unsigned char>(token.text[0])) != 0 ||
          std::string("+-.").find(token.text[0]) != std::string::npos);
}

TermPointer Combine(TermKind kind, std::vector<TermPointer> parts) {
  if (parts.size() == 1 && kind != TermKind::kNot) return parts[0];
  FilterTerm term;
  term.kind = kind;
  term.parts = std::move(parts);
  return std::make_shared<FilterTerm>(std::move(term));
}

/// Grammar: any = all {"or" all}; all = one {["and"] one}; one = "not" one | "(" any ")" | term.
class Parser {
 public:
  Parser(const std::string& text, const std::vector<Column>& columns)
      : tokens_(FilterTokens(text)), columns_(columns) {}

  TermPointer ParseWhole() {
    TermPointer root = ParseAny();
    if (Here().kind != TokenKind::kEnd) throw Expected("'and' or 'or'");
    return root;
  }

 private:
  const FilterToken& Here() const { return tokens_[at_]; }
  const FilterToken& Take() { return tokens_[at_++]; }

  std::invalid_argument Expected(const std::string& what) const {
    const std::string found = Here().kind == TokenKind::kEnd ? "the end" : "'" + Here().text + "'";
    return FilterError(Here().position, "expected " + what + " instead of " + found);
  }

  bool AtEndOfAll() const {
    return Here().kind == TokenKind::kEnd || Here().kind == TokenKind::kClose ||
           IsKeyword(Here(), "or");
  }

  TermPointer ParseAny() {
    std::vector<TermPointer> parts = {ParseAll()};
    while (IsKeyword(Here(), "or")) {
      Take();
      parts.push_back(ParseAll());
    }
    return Combine(TermKind::kOr, std::move(parts));
  }

  TermPointer ParseAll() {
    std::vector<TermPointer> parts = {ParseOne()};
    while (!AtEndOfAll()) {
      if (IsKeyword(Here(), "and")) Take();
      parts.push_back(ParseOne());
    }
    return Combine(TermKind::kAnd, std::move(parts));
  }

  TermPointer ParseOne() {
    if (depth_ == kMaxDepth) {
      throw FilterError(Here().position,
                        "expected at most " + std::to_string(kMaxDepth) + " nested terms");
    }
    ++depth_;
    TermPointer one = IsKeyword(Here(), "not")          ? ParseNot()
                      : Here().kind == TokenKind::kOpen ? ParseParentheses()
                                                        : ParseTerm();
    --depth_;
    return one;
  }

  TermPointer ParseNot() {
    Take();
    return Combine(TermKind::kNot, {ParseOne()});
  }

  TermPointer ParseParentheses() {
    Take();
    TermPointer inside = ParseAny();
    if (Here().kind != TokenKind::kClose) throw Expected("')'");
    Take();
    return inside;
  }

  TermPointer ParseTerm() {
    const bool is_word = Here().kind == TokenKind::kWord;
    if ((!is_word && Here().kind != TokenKind::kQuoted) || IsKeyword(Here(), "and") ||
        IsKeyword(Here(), "or")) {
      throw Expected("a column, a text or '('");
    }
    const FilterToken first = Take();
    if (is_word && Here().kind == TokenKind::kComparison) return ParseComparison(first);
    if (is_word && LooksLikeRange(Here())) return ParseRange(first);
    if (is_word && IsColumnOfNumbers(first.text) && FiniteNumber(Here().text)) {
      throw Expected("a comparison such as '=' after column '" + first.text + "'");
    }
    FilterTerm term;
    term.kind = TermKind::kAnyText;
    term.text = ToLowerCase(first.text);
    return std::make_shared<FilterTerm>(std::move(term));
  }

  TermPointer ParseComparison(const FilterToken& name) {
    const FilterToken comparison = Take();
    if (comparison.text == "!") {
      throw FilterError(comparison.position, "expected '!=' instead of '!'");
    }
    FilterTerm term;
    term.column = ColumnNamed(name);
    term.negated = comparison.text == "!=";
    const Column& column = columns_[term.column];
    if (column.kind == Column::Kind::kText) {
      SetText(comparison, column, &term);
    } else {
      SetNumber(comparison, column, &term);
    }
    Take();
    return std::make_shared<FilterTerm>(std::move(term));
  }

  void SetText(const FilterToken& comparison, const Column& column, FilterTerm* term) const {
    if (comparison.text[0] == '<' || comparison.text[0] == '>') {
      throw FilterError(comparison.position, "expected '=' or '!=' after the column of text '" +
                                                 column.name + "' instead of '" + comparison.text +
                                                 "'");
    }
    if (Here().kind != TokenKind::kWord && Here().kind != TokenKind::kQuoted) {
      throw Expected("a text");
    }
    term->kind = TermKind::kText;
    term->text = ToLowerCase(Here().text);
  }

  void SetNumber(const FilterToken& comparison, const Column& column, FilterTerm* term) const {
    const std::optional<double> number =
        Here().kind == TokenKind::kWord ? FiniteNumber(Here().text) : std::nullopt;
    if (!number) throw Expected("a number to compare '" + column.name + "' with");
    // Half of the last digit shown.
    const double tolerance = column.digits == 0 ? 0.0 : 0.5 * std::pow(10.0, -column.digits);
    const bool with_limit = comparison.text.size() == 2;
    term->kind = TermKind::kNumber;
    if (comparison.text[0] == '<') {
      term->interval = {-kInfinity, *number, true, with_limit};
    } else if (comparison.text[0] == '>') {
      term->interval = {*number, kInfinity, with_limit, true};
    } else {
      term->interval = {*number - tolerance, *number + tolerance, true, true};
    }
  }

  TermPointer ParseRange(const FilterToken& name) {
    FilterTerm term;
    term.kind = TermKind::kNumber;
    term.column = ColumnNamed(name);
    const Column& column = columns_[term.column];
    if (column.kind == Column::Kind::kText) {
      throw Expected("'=' or '!=' after the column of text '" + column.name + "'");
    }
    const std::size_t dots = Here().text.find("..");
    const auto low = FiniteNumber(Here().text.substr(0, dots));
    const auto high = FiniteNumber(Here().text.substr(dots + 2));
    if (!low || !high || *low > *high) throw Expected("a range such as 0.5..0.7");
    term.interval = {*low, *high, true, true};
    Take();
    return std::make_shared<FilterTerm>(std::move(term));
  }

  bool IsColumnOfNumbers(const std::string& name) const {
    return std::any_of(columns_.begin(), columns_.end(), [&](const Column& column) {
      return column.kind == Column::Kind::kNumber && column.name == ToLowerCase(name);
    });
  }

  /// The column of this name, or the only one whose name begins like that.
  int ColumnNamed(const FilterToken& token) const {
    const std::string name = ToLowerCase(token.text);
    std::vector<int> found;
    for (int i = 0; i < static_cast<int>(columns_.size()); ++i) {
      if (columns_[i].name == name) return i;
      if (columns_[i].name.compare(0, name.size(), name) == 0) found.push_back(i);
    }
    if (found.size() == 1) return found[0];
    throw FilterError(token.position,
                      "column '" + token.text + "' " +
                          (found.empty() ? "does not exist; did you mean '" + Nearest(name) + "'?"
                                         : "may be " + NamesOf(found) + ": expected more letters"));
  }

  std::string NamesOf(const std::vector<int>& columns) const {
    std::string names;
    for (const int column : columns) names += (names.empty() ? "" : ", ") + columns_[column].name;
    return names;
  }

  std::string Nearest(const std::string& name) const {
    return std::min_element(columns_.begin(), columns_.end(),
                            [&](const Column& a, const Column& b) {
                              return EditDistance(name, a.name) < EditDistance(name, b.name);
                            })
        ->name;
  }

  std::vector<FilterToken> tokens_;
  const std::vector<Column>& columns_;
  int at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string ToLowerCase(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return text;
}

std::shared_ptr<const FilterTerm> ParseFilter(const std::string& text,
                                              const std::vector<Column>& columns) {
  return Parser(text, columns).ParseWhole();
}

}  // namespace loopscope
