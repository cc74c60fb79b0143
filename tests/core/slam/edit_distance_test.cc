// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/edit_distance.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(EditDistance, CountsLettersToInsertDropAndReplace) {
  EXPECT_EQ(EditDistance("", ""), 0);
  EXPECT_EQ(EditDistance("score", "score"), 0);
  EXPECT_EQ(EditDistance("", "abc"), 3);
  EXPECT_EQ(EditDistance("scre", "score"), 1);
  EXPECT_EQ(EditDistance("score", "scre"), 1);
  EXPECT_EQ(EditDistance("scope", "score"), 1);
  EXPECT_EQ(EditDistance("kitten", "sitting"), 3);
}

}  // namespace
}  // namespace loopscope
