// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/config_value.h"

namespace loopscope {

/// A piece of Lua that was run.
struct LuaSource {
  std::string path;  ///< or, in parentheses, what it is if it is no file
  std::string text;
};

struct LuaRun {
  /// What the table that the main source returned holds, tables in it flattened ("a.b.c"), sorted
  /// by key. Functions and the like are left out.
  std::vector<ConfigEntry> values;
  std::vector<LuaSource> sources;  ///< the main one first, then those included, in order
};

/// Finds the text of a file that is included but does not stand beside the one that is run.
using LuaLibrary = std::optional<std::string> (*)(const std::string& name);

/// Runs `main` in a Lua that can compute and include, and nothing else: no files but those below
/// the folder of `main`, no programs, no clock, no dice. It may use 4 MB and 200 000 instructions,
/// some hundred times what a configuration needs. `include` and `choose` are Cartographer's. Throws
/// FileError that names file and line if anything goes wrong, or no table is returned.
LuaRun RunLua(const LuaSource& main, LuaLibrary library);

}  // namespace loopscope
