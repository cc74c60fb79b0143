// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/io/file_lock.h"
#include "core/sensor/scan_log.h"
#include "core/slam/options.h"

namespace SQLite {
class Database;
}

namespace loopscope {

/// Makes a recording without steps at `path`, in the place of another one if there is,
/// which is moved to its KeptRecording if it is finished. It is
/// written to `path`.part first; on failure, what was at `path` is as before. Nobody else can
/// replace it while the lock is kept, which must outlive all connections of this process to it.
/// Throws FileError, SQLite::Exception or std::filesystem::filesystem_error.
[[nodiscard]] FileLock CreateRecording(const std::string& path, const ScanLog& log,
                                       const Options& options);

/// Sets up a connection for transactions that the death of the process cannot hurt. Nothing is
/// flushed to the disk in between, so the death of the machine can.
void PrepareForAppending(SQLite::Database& database);

}  // namespace loopscope
