// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/slam/options.h"

namespace loopscope {

/// An option as a window shows and edits it.
struct OptionEntry {
  enum class Kind { kFlag, kWholeNumber, kNumber };

  std::string key;           ///< Cartographer's name
  std::string value;         ///< as SetFromText takes it
  std::string preset_value;  ///< likewise
  bool changed = false;      ///< from the preset
  Kind kind = Kind::kNumber;
  double minimum = 0.0;  ///< allowed; without meaning for a flag
  double maximum = 0.0;  ///< likewise
  std::string unit;      ///< "m", "rad", "s"; empty for a pure number
  std::string expected;  ///< e.g. "a number from 0.1 to 1000 [m]"
  std::string sentence;  ///< what it does
};

/// All options in the order of Cartographer's files, beside those of the preset that they are
/// compared with.
std::vector<OptionEntry> OptionRows(const Options& options, const Options& preset);

/// A text that was typed for an option.
struct OptionEdit {
  std::string key;
  std::string text;
};

/// `options` with the edits made, in their order. Throws OptionError, a std::invalid_argument, that
/// names the key and what was expected.
Options WithEdits(const Options& options, const std::vector<OptionEdit>& edits);

/// What is wrong with an edit, in one sentence; nothing if it may be made.
std::optional<std::string> ErrorOf(const OptionEdit& edit);

/// What `--set` needs to make `options` of `preset`: "key=value" of every option that is changed.
std::vector<std::string> AssignmentsOf(const Options& options, const Options& preset);

}  // namespace loopscope
