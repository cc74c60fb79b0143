// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/option_values.h"

#include <algorithm>
#include <cassert>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "core/slam/edit_distance.h"

namespace loopscope {
namespace {

OptionError BadValue(const OptionRow& row, const std::string& value) {
  return OptionError(fmt::format("{} = {}: expected {}", row.key, value, ExpectedValue(row)));
}

std::optional<OptionValue> ParseValue(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || rest != end) return std::nullopt;
  return number;
}

std::string Trim(const std::string& text) {
  constexpr const char* kBlanks = " \t\r";
  const size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string::npos) return "";
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

// `key` in two: the groups, and the name after the last dot.
std::pair<std::string, std::string> SplitKey(const std::string& key) {
  const size_t dot = key.rfind('.');
  if (dot == std::string::npos) return {"", key};
  return {key.substr(0, dot), key.substr(dot + 1)};
}

// Names weigh more than groups, which are left out or moved more often.
int KeyDistance(const std::string& a, const std::string& b) {
  constexpr int kNameWeight = 10;
  const auto [a_groups, a_name] = SplitKey(a);
  const auto [b_groups, b_name] = SplitKey(b);
  return kNameWeight * EditDistance(a_name, b_name) + EditDistance(a_groups, b_groups);
}

}  // namespace

std::string ExpectedValue(const OptionRow& row) {
  if (std::holds_alternative<bool*>(row.field)) return "true or false";
  const char* kind = std::holds_alternative<int*>(row.field) ? "a whole number" : "a number";
  const std::string unit = row.unit.empty() ? "" : " [" + row.unit + "]";
  return fmt::format("{} from {} to {}{}", kind, row.minimum, row.maximum, unit);
}

OptionValue GetValue(const OptionRow& row) {
  return std::visit(
      [](const auto* field) -> OptionValue {
        if constexpr (std::is_same_v<decltype(field), const bool*>) return *field;
        return static_cast<double>(*field);
      },
      row.field);
}

void SetValue(const OptionValue& value, const OptionRow& row) {
  const bool* const flag = std::get_if<bool>(&value);
  if (bool* const* field = std::get_if<bool*>(&row.field)) {
    if (!flag) throw BadValue(row, ToText(value));
    **field = *flag;
    return;
  }
  const double* const number = std::get_if<double>(&value);
  // Written so that NaN is out of range.
  if (!number || !(*number >= row.minimum && *number <= row.maximum)) {
    throw BadValue(row, ToText(value));
  }
  if (int* const* field = std::get_if<int*>(&row.field)) {
    if (*number != std::floor(*number)) throw BadValue(row, ToText(value));
    **field = static_cast<int>(*number);
  } else {
    *std::get<double*>(row.field) = *number;
  }
}

std::string ToText(const OptionValue& value) {
  return std::visit([](auto v) { return fmt::format("{}", v); }, value);
}

void SetFromText(const std::string& key, const std::string& value, Options* options) {
  std::vector<std::string> keys;
  for (const OptionRow& row : OptionTable(options)) {
    if (row.key == key) {
      const std::optional<OptionValue> parsed = ParseValue(value);
      if (!parsed) throw BadValue(row, "\"" + value + "\"");
      return SetValue(*parsed, row);
    }
    keys.push_back(row.key);
  }
  throw UnknownOption(key, keys);
}

void SetFromAssignment(const std::string& assignment, Options* options) {
  const size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw OptionError(fmt::format("\"{}\": expected key=value", assignment));
  }
  SetFromText(Trim(assignment.substr(0, equals)), Trim(assignment.substr(equals + 1)), options);
}

std::string OptionsToText(const Options& options) {
  Options copy = options;
  std::string text;
  for (const OptionRow& row : OptionTable(&copy)) {
    text += fmt::format("{} = {}\n", row.key, ToText(GetValue(row)));
  }
  return text;
}

Options ParseOptions(const std::string& text, const Options& defaults) {
  Options options = defaults;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    line = Trim(line);
    if (line.empty() || line[0] == '#') continue;
    try {
      SetFromAssignment(line, &options);
    } catch (const OptionError& error) {
      throw OptionError(error.what(), number);
    }
  }
  return options;
}

OptionError UnknownOption(const std::string& key, const std::vector<std::string>& known_keys) {
  assert(!known_keys.empty());
  const std::string& nearest = *std::min_element(
      known_keys.begin(), known_keys.end(),
      [&](const auto& a, const auto& b) { return KeyDistance(key, a) < KeyDistance(key, b); });
  return OptionError(fmt::format("unknown option \"{}\"; did you mean {}?", key, nearest));
}

}  // namespace loopscope
