// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace loopscope {

/// Says that a file is being written, to those who ask in the same way: an open file description
/// lock of Linux on a byte far behind those that SQLite locks. Stays with the file if that is
/// renamed; ends with this object, or with the process.
class FileLock {
 public:
  /// Locks the file at `path`, which is made if there is none. Throws FileError, of `named_path`,
  /// if it is locked or cannot be opened.
  FileLock(const std::string& path, const std::string& named_path);
  FileLock(FileLock&& other) noexcept;
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;
  FileLock& operator=(FileLock&&) = delete;
  ~FileLock();

 private:
  int file_;  ///< -1: none
};

}  // namespace loopscope
