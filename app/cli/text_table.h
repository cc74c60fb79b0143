// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace loopscope {

using TextRow = std::vector<std::string>;

/// Rows of equally many fields below each other: the first column flush left, the others flush
/// right, two spaces apart.
std::string AlignedTable(const std::vector<TextRow>& rows);

/// `text` as a field of CSV (RFC 4180).
std::string CsvField(const std::string& text);

}  // namespace loopscope
