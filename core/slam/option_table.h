// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <variant>
#include <vector>

#include "core/slam/options.h"

namespace loopscope {

/// One option: what it is called, where it lives, what it may be, and what it does.
struct OptionRow {
  std::string key;  ///< Cartographer's name, e.g. "POSE_GRAPH.optimize_every_n_nodes"
  std::variant<bool*, int*, double*> field;  ///< in the Options that the table was made for
  double minimum = 0.0;                      ///< allowed; without meaning for a bool
  double maximum = 0.0;                      ///< likewise
  std::string unit;                          ///< "m", "rad", "s"; empty for a pure number
  std::string sentence;
};

/// All options, in the order of Cartographer's files; the fields point into `options`. Options
/// files, the command line, recordings, the inspector and the documentation go by this table.
std::vector<OptionRow> OptionTable(Options* options);

}  // namespace loopscope
