// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/filter_token.h"

#include <algorithm>
#include <string_view>

namespace loopscope {
namespace {

using Kind = FilterToken::Kind;

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kQuotes = "\"'";
constexpr std::string_view kEndsOfWords = " \t\r\n\"'()<>=!";

bool Contains(std::string_view set, char c) { return set.find(c) != std::string_view::npos; }

/// Takes words from the front of a filter.
class Scanner {
 public:
  explicit Scanner(std::string_view text) : text_(text) {}

  FilterToken Next() {
    at_ = std::min(text_.find_first_not_of(kBlanks, at_), text_.size());
    if (at_ == text_.size()) return Take(Kind::kEnd, 0);
    const char first = text_[at_];
    if (first == '(') return Take(Kind::kOpen, 1);
    if (first == ')') return Take(Kind::kClose, 1);
    if (Contains(kQuotes, first)) return Quoted();
    if (Contains("<>=!", first)) {
      const bool with_equals = text_.substr(at_ + 1, 1) == "=";
      return Take(Kind::kComparison, with_equals ? 2 : 1);
    }
    return Take(Kind::kWord, std::min(text_.find_first_of(kEndsOfWords, at_), text_.size()) - at_);
  }

 private:
  FilterToken Take(Kind kind, std::size_t length) {
    const FilterToken token{kind, std::string(text_.substr(at_, length)),
                            static_cast<int>(at_) + 1};
    at_ += length;
    return token;
  }

  FilterToken Quoted() {
    const std::size_t end = text_.find(text_[at_], at_ + 1);
    if (end == std::string_view::npos) {
      throw FilterError(static_cast<int>(at_) + 1,
                        std::string("expected another ") + text_[at_] + " to close the quote");
    }
    FilterToken token = Take(Kind::kQuoted, end + 1 - at_);
    token.text = token.text.substr(1, token.text.size() - 2);
    return token;
  }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace

std::vector<FilterToken> FilterTokens(const std::string& text) {
  Scanner scanner(text);
  std::vector<FilterToken> tokens = {scanner.Next()};
  while (tokens.back().kind != Kind::kEnd) tokens.push_back(scanner.Next());
  return tokens;
}

std::invalid_argument FilterError(int position, const std::string& what) {
  return std::invalid_argument("filter, position " + std::to_string(position) + ": " + what);
}

}  // namespace loopscope
