// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loopscope {

/// Longest line that a LineReader hands out [bytes]; some 100 000 readings of a scan fit.
constexpr std::size_t kMaxLineLength = std::size_t{1} << 20;

/// Reads a text file, plain or gzip (told apart by content, not by name), line by line. It holds
/// one line at a time, whatever the file says.
class LineReader {
 public:
  /// Throws FileError if the file cannot be opened.
  explicit LineReader(const std::string& path);
  ~LineReader();

  /// The next line without its end (LF or CR LF), valid until the next call; nothing after the last
  /// one. Of a line longer than kMaxLineLength the rest is dropped, see truncated().
  /// Throws FileError if the file cannot be read, or is damaged gzip data.
  std::optional<std::string_view> Next();

  int line_number() const { return line_number_; }  ///< of the line from Next(), counted from 1
  bool truncated() const { return truncated_; }     ///< whether that line was too long
  bool unfinished() const { return unfinished_; }   ///< whether that line had no end

  /// Whether the gzip data ended before they said that they would. Known at the end.
  bool ends_early() const { return ends_early_; }

 private:
  struct GzipFile;

  bool FillBuffer();

  std::string path_;
  std::unique_ptr<GzipFile> file_;
  std::vector<char> buffer_;
  std::size_t position_ = 0;  ///< of the first byte of the buffer that was not handed out
  std::size_t size_ = 0;      ///< bytes in the buffer
  std::string line_;
  int line_number_ = 0;
  bool truncated_ = false;
  bool unfinished_ = false;
  bool ends_early_ = false;
};

}  // namespace loopscope
