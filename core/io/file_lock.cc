// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/file_lock.h"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <utility>

#include <sys/stat.h>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

int OpenFile(const std::string& path, const std::string& named_path) {
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file >= 0) return file;
  throw FileError(named_path, std::string("cannot be written: ") + std::strerror(errno));
}

/// False if somebody else has locked it. Some file systems have no locks.
bool Lock(int file) {
  struct flock byte = {};
  byte.l_type = F_WRLCK;
  byte.l_whence = SEEK_SET;
  byte.l_start = off_t{1} << 62;
  byte.l_len = 1;
  return fcntl(file, F_OFD_SETLK, &byte) == 0 || (errno != EAGAIN && errno != EACCES);
}

/// Whether `path` still names the file: another run may have renamed it meanwhile.
bool IsAt(const std::string& path, int file) {
  struct stat opened = {};
  struct stat named = {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

FileLock::FileLock(const std::string& path, const std::string& named_path)
    : file_(OpenFile(path, named_path)) {
  if (Lock(file_) && IsAt(path, file_)) return;
  close(file_);
  throw FileError(named_path, "is being written by another run; expected it to end first");
}

FileLock::FileLock(FileLock&& other) noexcept : file_(std::exchange(other.file_, -1)) {}

FileLock::~FileLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace loopscope
