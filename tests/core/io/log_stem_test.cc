// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/log_stem.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(LogStem, IsThePathWithoutWhatNamesALog) {
  EXPECT_EQ(LogStem("a/office.log.gz"), "a/office");
  EXPECT_EQ(LogStem("mit-csail.clf"), "mit-csail");
  EXPECT_EQ(LogStem("office"), "office");
}

TEST(LogStem, KeepsOtherDots) {
  EXPECT_EQ(LogStem("a.b/2023.05.01.log"), "a.b/2023.05.01");
  EXPECT_EQ(LogStem("run.txt"), "run.txt");
}

}  // namespace
}  // namespace loopscope
