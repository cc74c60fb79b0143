// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace loopscope {

/// Packs numbers into bytes, little endian.
class ByteWriter {
 public:
  void PutByte(std::uint8_t value) { bytes_.push_back(static_cast<char>(value)); }
  /// Seven bits a byte, low ones first: small numbers are short.
  void PutUnsigned(std::uint64_t value);
  /// Likewise, with the sign in the lowest bit.
  void PutSigned(std::int64_t value);
  void PutBits64(std::uint64_t value);
  void PutBits32(std::uint32_t value);

  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

/// Unpacks what a ByteWriter packed.
class ByteReader {
 public:
  /// `bytes` must live as long as the reader. `file` and `where` (e.g. "scans from 200 on") are for
  /// the FileError that every Get throws if there is no such number.
  ByteReader(std::string_view bytes, std::string file, std::string where)
      : bytes_(bytes), file_(std::move(file)), where_(std::move(where)) {}

  std::uint8_t GetByte();
  std::uint64_t GetUnsigned();
  std::int64_t GetSigned();
  std::uint64_t GetBits64();
  std::uint32_t GetBits32();
  /// A number of things that take at least `min_bytes` >= 1 each, so that no damaged count can ask
  /// for more memory than the bytes are worth.
  std::size_t GetCount(std::size_t min_bytes = 1);

  /// Fails if less than `num_bytes` are left.
  void ExpectLeft(std::size_t num_bytes) const;
  /// Fails if something is left.
  void ExpectEnd() const;

  /// Throws FileError that the data are damaged.
  [[noreturn]] void Fail(const std::string& what) const;

 private:
  std::string_view bytes_;
  std::string file_;
  std::string where_;
};

}  // namespace loopscope
