// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/compression.h"

#include <gtest/gtest.h>

#include "core/io/file_error.h"

namespace loopscope {
namespace {

TEST(Compression, BytesComeBack) {
  for (const std::string& bytes : {std::string(), std::string("abc"), std::string(1000000, 'x')}) {
    EXPECT_EQ(Decompress(Compress(bytes), 1000000, "a", "b"), bytes);
  }
}

TEST(Compression, MoreThanTheLimitThrows) {
  const std::string bomb = Compress(std::string(1000001, '\0'));
  EXPECT_LT(bomb.size(), 2000u);
  EXPECT_THROW(Decompress(bomb, 1000000, "a", "b"), FileError);
}

TEST(Compression, WhatIsNoCompleteStreamThrows) {
  const std::string whole = Compress("some bytes that are compressed");
  EXPECT_THROW(Decompress(whole.substr(0, whole.size() - 1), 1000, "a", "b"), FileError);
  EXPECT_THROW(Decompress("", 1000, "a", "b"), FileError);
  EXPECT_THROW(Decompress("garbage", 1000, "a", "b"), FileError);
}

}  // namespace
}  // namespace loopscope
