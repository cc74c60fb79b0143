// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/words.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

TEST(SplitWords, SplitsAtSpacesTabsAndCarriageReturns) {
  std::vector<std::string_view> words = {"left from before"};
  SplitWords("  ODOM\t1.5  2 \r", &words);
  EXPECT_THAT(words, ElementsAre("ODOM", "1.5", "2"));
  SplitWords(" \t ", &words);
  EXPECT_THAT(words, IsEmpty());
}

TEST(ParseDouble, TakesWhatIsANumberAndNothingElse) {
  EXPECT_EQ(ParseDouble("-1.25e2"), -125.0);
  EXPECT_EQ(ParseDouble("+3"), 3.0);
  EXPECT_EQ(ParseDouble("976052857.337530"), 976052857.337530);
  EXPECT_TRUE(std::isnan(ParseDouble("nan").value()));
  EXPECT_TRUE(std::isinf(ParseDouble("-inf").value()));
  for (const char* word : {"", "+", "+-1", "1.5x", "x1", "1,5", "1e999", "--1"}) {
    EXPECT_FALSE(ParseDouble(word)) << word;
  }
}

TEST(ParseInt, RejectsFractionsAndWhatIsTooLarge) {
  EXPECT_EQ(ParseInt("181"), 181);
  EXPECT_FALSE(ParseInt("181.0"));
  EXPECT_FALSE(ParseInt("10000000000"));
}

}  // namespace
}  // namespace loopscope
