// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/sensor/scan_log.h"
#include "core/slam/options.h"

namespace SQLite {
class Database;
}

namespace loopscope {

// What a recording has from the start on: the log that is mapped, and the options.

/// Writes into empty tables. Throws SQLite::Exception.
void WriteRecordedLog(const ScanLog& log, SQLite::Database& database);
void WriteRecordedOptions(const Options& options, SQLite::Database& database);

/// The log, checked for consistency. Throws FileError about `path`, or SQLite::Exception.
ScanLog ReadRecordedLog(const std::string& path, SQLite::Database& database);

/// Likewise the options; those that the recording does not have are off or at their defaults.
Options ReadRecordedOptions(const std::string& path, SQLite::Database& database);

}  // namespace loopscope
