// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_creation.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
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

/// Throws the reason why no file can be made at `path`, which SQLite does not tell.
void MakeEmptyFile(const std::string& path, const std::string& named_path) {
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) {
    throw FileError(named_path, std::string("cannot be written: ") + std::strerror(errno));
  }
  std::fclose(file);
}

/// A journal beside a recording belongs to its last step. It must not come upon another recording,
/// nor the recording lose it: SQLite puts this right when it reads the file.
void SettleJournal(const std::string& path) {
  if (!fs::exists(path + "-journal")) return;
  SQLite::Database(path, SQLite::OPEN_READWRITE).execAndGet("SELECT count(*) FROM step");
  fs::remove(path + "-journal");
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

void CreateRecording(const std::string& path, const ScanLog& log, const Options& options) {
  CheckReplaceable(path);
  const std::string part = path + ".part";
  fs::remove(part + "-journal");
  MakeEmptyFile(part, path);
  try {
    WriteWithoutSteps(part, log, options);
    SettleJournal(path);
    fs::rename(part, path);
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
