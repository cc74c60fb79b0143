// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>

namespace loopscope {

/// A file that cannot be read or written. The message is one line: which file, where in it (line or
/// byte, if that means anything), what is wrong and what was expected.
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& what)
      : std::runtime_error(path + ": " + what) {}
  FileError(const std::string& path, int line, const std::string& what)
      : std::runtime_error(path + ":" + std::to_string(line) + ": " + what) {}
};

}  // namespace loopscope
