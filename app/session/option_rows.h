// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/slam/options.h"

namespace loopscope {

/// An option as a window shows it.
struct OptionEntry {
  std::string key;           ///< Cartographer's name
  std::string value;         ///< as SetFromText takes it
  std::string preset_value;  ///< likewise
  bool changed = false;      ///< from the preset
  std::string unit;          ///< "m", "rad", "s"; empty for a pure number
  std::string expected;      ///< e.g. "a number from 0.1 to 1000 [m]"
  std::string sentence;      ///< what it does
};

/// All options in the order of Cartographer's files, beside those of the preset that they are
/// compared with.
std::vector<OptionEntry> OptionRows(const Options& options, const Options& preset);

}  // namespace loopscope
