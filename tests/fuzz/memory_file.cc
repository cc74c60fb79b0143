// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/fuzz/memory_file.h"

#include <cerrno>
#include <system_error>
#include <unistd.h>

#include <sys/mman.h>

namespace loopscope {

MemoryFile::MemoryFile(const std::uint8_t* data, std::size_t size)
    : descriptor_(memfd_create("input", MFD_CLOEXEC)) {
  if (descriptor_ < 0) throw std::system_error(errno, std::generic_category(), "memfd_create");
  if (write(descriptor_, data, size) != static_cast<ssize_t>(size)) {
    close(descriptor_);
    throw std::system_error(errno, std::generic_category(), "write");
  }
}

MemoryFile::~MemoryFile() { close(descriptor_); }

}  // namespace loopscope
