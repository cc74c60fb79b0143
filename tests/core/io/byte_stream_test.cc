// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/byte_stream.h"

#include <cstdint>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

ByteReader ReaderOf(const std::string& bytes) { return ByteReader(bytes, "a.file", "its end"); }

TEST(ByteStream, NumbersComeBack) {
  constexpr std::int64_t kSmallest = std::numeric_limits<std::int64_t>::min();
  constexpr std::uint64_t kLargest = std::numeric_limits<std::uint64_t>::max();
  ByteWriter writer;
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{63},
                                   std::int64_t{-64}, std::int64_t{1} << 40, kSmallest}) {
    writer.PutSigned(value);
  }
  writer.PutUnsigned(kLargest);
  writer.PutBits64(kLargest - 1);
  writer.PutBits32(0xdeadbeef);
  ByteReader reader = ReaderOf(writer.bytes());
  for (const std::int64_t value : {std::int64_t{0}, std::int64_t{-1}, std::int64_t{63},
                                   std::int64_t{-64}, std::int64_t{1} << 40, kSmallest}) {
    EXPECT_EQ(reader.GetSigned(), value);
  }
  EXPECT_EQ(reader.GetUnsigned(), kLargest);
  EXPECT_EQ(reader.GetBits64(), kLargest - 1);
  EXPECT_EQ(reader.GetBits32(), 0xdeadbeef);
  reader.ExpectEnd();
}

TEST(ByteStream, SmallNumbersAreOneByte) {
  ByteWriter writer;
  writer.PutSigned(-64);
  writer.PutUnsigned(127);
  EXPECT_EQ(writer.bytes().size(), 2u);
}

TEST(ByteStream, BytesThatEndEarlyThrow) {
  EXPECT_EQ(MessageOf([] { ReaderOf("\xff\xff").GetUnsigned(); }),
            "a.file: damaged data, its end: they end early");
  EXPECT_THROW(ReaderOf("abc").GetBits32(), FileError);
  EXPECT_THROW(ReaderOf("abc").ExpectLeft(4), FileError);
}

TEST(ByteStream, ANumberOfMoreThan64BitsThrows) {
  EXPECT_THAT(MessageOf([] { ReaderOf(std::string(11, '\xff')).GetUnsigned(); }),
              HasSubstr("too long"));
}

TEST(ByteStream, ACountThatTheBytesCannotHoldThrows) {
  ByteWriter writer;
  writer.PutUnsigned(3);
  EXPECT_EQ(ReaderOf(writer.bytes() + "12345678901234567890abcd").GetCount(8), 3u);
  EXPECT_THROW(ReaderOf(writer.bytes() + "12345678901234567890abc").GetCount(8), FileError);
}

TEST(ByteStream, SomethingBehindTheEndThrows) {
  EXPECT_THROW(ReaderOf("x").ExpectEnd(), FileError);
}

}  // namespace
}  // namespace loopscope
