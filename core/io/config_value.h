// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>

namespace loopscope {

/// What a configuration can set an option to.
using ConfigValue = std::variant<bool, double, std::string>;

struct ConfigEntry {
  std::string key;  ///< names of the tables and of the option, e.g. "POSE_GRAPH.log_matches"
  ConfigValue value;
};

/// As it stands in a Lua file: false, 0.05, "PROBABILITY_GRID".
std::string ToLua(const ConfigValue& value);

}  // namespace loopscope
