// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace loopscope {

/// Relations and TUM trajectories alike have eight columns.
using NumberRow = std::array<double, 8>;

/// What rows must satisfy.
struct RowCondition {
  std::function<bool(const NumberRow&)> holds;
  std::string what;  ///< for messages
};

/// The rows of a text file with eight finite numbers a line; empty lines and those with # at the
/// head are skipped. `columns` names the columns, for messages. Throws FileError if the file cannot
/// be read, a line is something else or does not satisfy `condition`, or there is no row.
std::vector<NumberRow> ReadNumberRows(const std::string& path, const std::string& columns,
                                      const std::optional<RowCondition>& condition = std::nullopt);

}  // namespace loopscope
