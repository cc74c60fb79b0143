// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/byte_stream.h"

#include "core/io/file_error.h"

namespace loopscope {

void ByteWriter::PutUnsigned(std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) PutByte(static_cast<std::uint8_t>(value | 0x80));
  PutByte(static_cast<std::uint8_t>(value));
}

void ByteWriter::PutSigned(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  PutUnsigned(value < 0 ? ~(bits << 1) : bits << 1);
}

void ByteWriter::PutBits64(std::uint64_t value) {
  for (int i = 0; i < 8; ++i, value >>= 8) PutByte(static_cast<std::uint8_t>(value));
}

void ByteWriter::PutBits32(std::uint32_t value) {
  for (int i = 0; i < 4; ++i, value >>= 8) PutByte(static_cast<std::uint8_t>(value));
}

std::uint8_t ByteReader::GetByte() {
  if (bytes_.empty()) Fail("they end early");
  const auto byte = static_cast<std::uint8_t>(bytes_.front());
  bytes_.remove_prefix(1);
  return byte;
}

std::uint64_t ByteReader::GetUnsigned() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 7) {
    const std::uint8_t byte = GetByte();
    value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
    if (byte < 0x80) return value;
  }
  Fail("a number is too long");
}

std::int64_t ByteReader::GetSigned() {
  const std::uint64_t folded = GetUnsigned();
  return static_cast<std::int64_t>((folded & 1) != 0 ? ~(folded >> 1) : folded >> 1);
}

std::uint64_t ByteReader::GetBits64() {
  std::uint64_t value = 0;
  for (int shift = 0; shift < 64; shift += 8) value |= std::uint64_t{GetByte()} << shift;
  return value;
}

std::uint32_t ByteReader::GetBits32() {
  std::uint32_t value = 0;
  for (int shift = 0; shift < 32; shift += 8) value |= std::uint32_t{GetByte()} << shift;
  return value;
}

std::size_t ByteReader::GetCount(std::size_t min_bytes) {
  const std::uint64_t count = GetUnsigned();
  if (count > bytes_.size() / min_bytes) Fail("a count is too large");
  return static_cast<std::size_t>(count);
}

void ByteReader::ExpectLeft(std::size_t num_bytes) const {
  if (bytes_.size() < num_bytes) Fail("they end early");
}

void ByteReader::Fail(const std::string& what) const {
  throw FileError(file_, "damaged data, " + where_ + ": " + what);
}

void ByteReader::ExpectEnd() const {
  if (!bytes_.empty()) Fail("there is something behind their end");
}

}  // namespace loopscope
