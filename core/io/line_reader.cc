// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/line_reader.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <zlib.h>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

constexpr std::size_t kBufferSize = std::size_t{1} << 17;

}  // namespace

struct LineReader::GzipFile {
  gzFile handle = nullptr;
  ~GzipFile() {
    if (handle != nullptr) gzclose(handle);
  }
};

LineReader::LineReader(const std::string& path)
    : path_(path), file_(std::make_unique<GzipFile>()), buffer_(kBufferSize) {
  errno = 0;
  file_->handle = gzopen(path.c_str(), "rb");
  if (file_->handle == nullptr) {
    throw FileError(path, std::string("cannot be opened: ") + std::strerror(errno));
  }
}

LineReader::~LineReader() = default;

bool LineReader::FillBuffer() {
  const int num_read = gzread(file_->handle, buffer_.data(), static_cast<unsigned>(kBufferSize));
  int error = Z_OK;
  const char* message = gzerror(file_->handle, &error);
  if (error == Z_ERRNO) throw FileError(path_, std::string("cannot be read: ") + strerror(errno));
  ends_early_ = error == Z_BUF_ERROR;
  if (num_read < 0 && !ends_early_) {
    throw FileError(path_, line_number_ + 1, std::string("damaged gzip data: ") + message);
  }
  position_ = 0;
  size_ = static_cast<std::size_t>(std::max(num_read, 0));
  return size_ > 0;
}

std::optional<std::string_view> LineReader::Next() {
  line_.clear();
  truncated_ = false;
  unfinished_ = true;
  bool any = false;
  while (unfinished_ && (position_ < size_ || FillBuffer())) {
    any = true;
    const char* const begin = buffer_.data() + position_;
    const char* const end = buffer_.data() + size_;
    const char* const line_feed = std::find(begin, end, '\n');
    const std::size_t length = static_cast<std::size_t>(line_feed - begin);
    const std::size_t kept = std::min(length, kMaxLineLength - line_.size());
    line_.append(begin, kept);
    truncated_ = truncated_ || kept < length;
    unfinished_ = line_feed == end;
    position_ += length + (unfinished_ ? 0 : 1);
  }
  if (!any) return std::nullopt;
  ++line_number_;
  if (!line_.empty() && line_.back() == '\r') line_.pop_back();
  return line_;
}

}  // namespace loopscope
