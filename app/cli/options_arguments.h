// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "core/slam/options.h"

namespace CLI {
class App;
}

namespace loopscope {

/// The arguments that choose the options of a run.
struct OptionsArguments {
  std::string file;                      ///< --options
  std::string preset;                    ///< --preset
  std::vector<std::string> assignments;  ///< --set
  bool no_odometry = false;              ///< --no-odometry
};

void AddOptionsArguments(CLI::App* command, OptionsArguments* arguments);

/// The options that the arguments ask for. What an options file says in vain goes to stderr. Throws
/// FileError or OptionError.
Options ToOptions(const OptionsArguments& arguments);

}  // namespace loopscope
