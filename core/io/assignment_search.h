// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/lua_sandbox.h"

namespace loopscope {

struct SourceLine {
  std::string path;
  int line = 0;  ///< counted from 1
};

/// Where `key` (e.g. "POSE_GRAPH.log_matches") got its value, told from the text: the last line
/// that assigns to it by its full name, else by the longest end of its name ("log_matches = ..." in
/// a table); the first source, which overrides those that it includes, comes before the others.
/// Nothing if no line does.
std::optional<SourceLine> FindAssignment(const std::vector<LuaSource>& sources,
                                         const std::string& key);

}  // namespace loopscope
