// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_creation.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include "core/io/file_error.h"
#include "core/io/recorded_log.h"
#include "core/io/recording_file.h"
#include "core/io/recording_schema.h"

namespace loopscope {
namespace {

namespace fs = std::filesystem;

void WriteWithoutSteps(const std::string& path, const ScanLog& log, const Options& options) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
  PrepareForAppending(database);
  SQLite::Transaction transaction(database);
  database.exec(fmt::format("PRAGMA application_id = {}", kRecordingApplicationId));
  database.exec(fmt::format("PRAGMA user_version = {}", kRecordingSchemaVersion));
  database.exec(kRecordingSchema);
  WriteRecordedLog(log, database);
  WriteRecordedOptions(options, database);
  transaction.commit();
}

/// A journal beside a recording belongs to its last step. It must not come upon another recording,
/// nor the recording lose it: SQLite puts this right when it reads the file.
void SettleJournal(const std::string& path) {
  const std::string journal = path + "-journal";
  if (fs::exists(journal) && IsRecording(path)) {
    SQLite::Database(path, SQLite::OPEN_READWRITE).execAndGet("SELECT count(*) FROM step");
  }
  fs::remove(journal);
}

/// Whether a recording went to its end; or that cannot be read, which is for the user to judge.
bool MayBeFinished(const std::string& path) {
  try {
    return ReadWallSeconds(path).has_value();
  } catch (const FileError&) {
    return true;
  }
}

/// Moves a recording that went to its end out of the way of one that may not.
void KeepIfFinished(const std::string& path) {
  if (IsRecording(path) && MayBeFinished(path)) fs::rename(path, KeptRecording(path));
}

void CheckReplaceable(const std::string& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (!fs::exists(status)) return;
  const bool empty = fs::is_regular_file(status) && fs::file_size(path, ignored) == 0;
  if (!empty && !IsRecording(path)) {
    throw FileError(path, "exists and is no recording; expected a new file, or one to replace");
  }
}

}  // namespace

FileLock CreateRecording(const std::string& path, const ScanLog& log, const Options& options) {
  CheckReplaceable(path);
  const std::string part = path + ".part";
  FileLock lock(part, path);
  try {
    fs::resize_file(part, 0);
    fs::remove(part + "-journal");
    WriteWithoutSteps(part, log, options);
    std::optional<FileLock> replaced;
    if (fs::exists(path)) replaced.emplace(path, path);
    SettleJournal(path);
    KeepIfFinished(path);
    fs::rename(part, path);
    return lock;
  } catch (...) {
    std::error_code ignored;
    fs::remove(part, ignored);
    fs::remove(part + "-journal", ignored);
    throw;
  }
}

void PrepareForAppending(SQLite::Database& database) {
  database.exec("PRAGMA synchronous = OFF");
  database.exec("PRAGMA journal_mode = DELETE");
}

}  // namespace loopscope
