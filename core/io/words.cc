// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/words.h"

#include <algorithm>
#include <charconv>
#include <system_error>

namespace loopscope {
namespace {

template <typename T>
std::optional<T> ParseWhole(std::string_view word) {
  if (word.size() > 1 && word.front() == '+' && word[1] != '-') word.remove_prefix(1);
  T value{};
  const char* const end = word.data() + word.size();
  const std::from_chars_result result = std::from_chars(word.data(), end, value);
  if (result.ec != std::errc{} || result.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

void SplitWords(std::string_view line, std::vector<std::string_view>* words) {
  constexpr std::string_view kBlanks = " \t\r";
  words->clear();
  std::size_t begin = line.find_first_not_of(kBlanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, begin), line.size());
    words->push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlanks, end);
  }
}

std::optional<double> ParseDouble(std::string_view word) { return ParseWhole<double>(word); }

std::optional<int> ParseInt(std::string_view word) { return ParseWhole<int>(word); }

}  // namespace loopscope
