// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "core/slam/option_table.h"

namespace loopscope {

/// An unknown key, or a value that does not fit. The message names the key, the value and what was
/// expected.
class OptionError : public std::invalid_argument {
 public:
  explicit OptionError(const std::string& what, int line = 0)
      : std::invalid_argument(what), line_(line) {}

  /// In the text that was parsed, counted from 1; 0 if there was none.
  int line() const { return line_; }

 private:
  int line_;
};

using OptionValue = std::variant<bool, double>;

OptionValue GetValue(const OptionRow& row);

/// What the option may be, e.g. "a number from 0.1 to 1000 [m]".
std::string ExpectedValue(const OptionRow& row);

/// Throws OptionError if `value` is of the wrong kind or out of range.
void SetValue(const OptionValue& value, const OptionRow& row);

/// "true", "40", "0.05": as few digits as give the same value again.
std::string ToText(const OptionValue& value);

/// Sets the option of `key` from text. Throws OptionError; if the key is unknown, the message names
/// the nearest one.
void SetFromText(const std::string& key, const std::string& value, Options* options);

/// Sets an option from "key=value", as on the command line. Throws OptionError.
void SetFromAssignment(const std::string& assignment, Options* options);

/// All options, one "key = value" a line. ParseOptions gives back the same.
std::string OptionsToText(const Options& options);

/// Sets what `text` assigns and takes the rest from `defaults`. Empty lines and lines that begin
/// with '#' say nothing. Throws OptionError that has the line.
Options ParseOptions(const std::string& text, const Options& defaults);

/// To be thrown for a key that is not one of `known_keys` (at least one). It names the one that is
/// most like it; names count more than the groups before them: "max_rnge" and "SUBMAPS.max_range"
/// are both most like "TRAJECTORY_BUILDER_2D.max_range".
OptionError UnknownOption(const std::string& key, const std::vector<std::string>& known_keys);

}  // namespace loopscope
