// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/slam/options.h"

namespace loopscope {

struct OptionsFile {
  Options options;
  /// What the file sets and Loopscope does not use, and what it lacks; a line each.
  std::vector<std::string> notes;
};

/// Reads options. A file that ends in .lua is a configuration of Cartographer (or of
/// cartographer_ros), taken as it is: what it includes is looked up in its folder, else it is
/// Cartographer's stock file of this name; what it does not set is as in CartographerPreset(). Any
/// other file has "key = value" lines, as OptionsToText writes them; the rest is as in
/// LoopscopePreset(). Throws FileError that names file and line if the file cannot be read or run,
/// sets an option that does not exist (the nearest one is named), or sets one to a value that it
/// cannot have.
OptionsFile ReadOptionsFile(const std::string& path);

/// Likewise, of the text of a Lua file.
OptionsFile ParseLuaOptions(const std::string& path, const std::string& text);

}  // namespace loopscope
