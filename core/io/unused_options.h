// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/io/config_value.h"

namespace loopscope {

/// An option of Cartographer or cartographer_ros that Loopscope has no use for.
struct UnusedOption {
  std::string key;
  std::optional<ConfigValue> stock_value;  ///< nothing if it is only read where a file sets it
  bool shapes_map = true;  ///< whether another value than the stock one would give another map
};

/// Those of Cartographer's stock files (see UnusedStockOptions), and those that configurations have
/// beside them.
std::vector<UnusedOption> UnusedOptions();

}  // namespace loopscope
