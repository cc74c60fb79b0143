// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/text_file.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/io/file_error.h"

namespace loopscope {

std::string ReadTextFile(const std::string& path) {
  constexpr size_t kMaxSize = 1 << 20;  // [bytes]
  std::error_code unreadable;           // which opening it tells
  if (std::filesystem::is_directory(path, unreadable))
    throw FileError(path, "is a folder; expected a file");
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, std::string("cannot be opened: ") + std::strerror(errno));
  std::string text(kMaxSize + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad()) throw FileError(path, std::string("cannot be read: ") + std::strerror(errno));
  text.resize(static_cast<size_t>(file.gcount()));
  if (text.size() > kMaxSize) throw FileError(path, "has more than 1 MB; expected a text file");
  return text;
}

}  // namespace loopscope
