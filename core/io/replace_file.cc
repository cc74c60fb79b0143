// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/replace_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

namespace fs = std::filesystem;

/// 0, or the reason (errno) why it failed.
int WriteAll(const std::string& path, std::string_view content) {
  errno = 0;
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  if (file == nullptr) return errno;
  const bool written = std::fwrite(content.data(), 1, content.size(), file) == content.size();
  const int write_error = written ? 0 : errno;
  const bool closed = std::fclose(file) == 0;
  if (!written) return write_error;
  return closed ? 0 : errno;
}

FileError CannotWrite(const std::string& path, int error) {
  return FileError(path, std::string("cannot be written: ") + std::strerror(error));
}

}  // namespace

void ReplaceFile(const std::string& path, std::string_view content) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) throw CannotWrite(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    if (const int error = WriteAll(path, content)) throw CannotWrite(path, error);
    return;
  }
  const fs::path target =
      fs::is_symlink(path, ignored) ? fs::weakly_canonical(path, ignored) : fs::path(path);
  const std::string beside = target.string() + ".part";
  if (const int error = WriteAll(beside, content)) {
    if (fs::is_regular_file(beside, ignored)) fs::remove(beside, ignored);
    throw CannotWrite(path, error);
  }
  std::error_code renamed;
  fs::rename(beside, target, renamed);
  if (renamed) {
    fs::remove(beside, ignored);
    throw CannotWrite(path, renamed.value());
  }
}

}  // namespace loopscope
