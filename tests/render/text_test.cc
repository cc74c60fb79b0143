// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/text.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr TextStyle kStyle{20, Weight::kRegular, {}};

TEST(TextWidthTest, GrowsWithTheTextAndWithTheFont) {
  EXPECT_EQ(TextWidth("", kStyle), 0.0);
  EXPECT_GT(TextWidth("submap", kStyle), 1.8 * TextWidth("sub", kStyle));
  const TextStyle larger{40, Weight::kRegular, {}};
  EXPECT_NEAR(TextWidth("submap", larger), 2.0 * TextWidth("submap", kStyle), 10.0);
}

TEST(ToUtf8Test, ReplacesWhatIsNone) {
  EXPECT_EQ(ToUtf8("Bühl 0.5 µm"), "Bühl 0.5 µm");
  EXPECT_EQ(ToUtf8("a\xff z"), "a\uFFFD z");
}

TEST(ShortenToFitTest, LeavesATextThatFits) {
  EXPECT_EQ(ShortenToFit("score", kStyle, TextWidth("score", kStyle)), "score");
}

TEST(ShortenToFitTest, CutsTheEndOffUntilTheRestFitsWithAnEllipsis) {
  const double width = TextWidth("a long s…", kStyle);
  const std::string shortened = ShortenToFit("a long story of a short loop", kStyle, width);
  EXPECT_EQ(shortened, "a long s…");
  EXPECT_LE(TextWidth(shortened, kStyle), width);
}

TEST(ShortenToFitTest, NeverCutsALetterInTwo) {
  const std::string text = "ξξξξξξξξ";
  for (double width = 0.0; width < 100.0; width += 3.0) {
    const std::string shortened = ShortenToFit(text, kStyle, width);
    EXPECT_EQ((shortened.size() - (shortened.empty() || shortened == text ? 0 : 3)) % 2, 0u)
        << shortened;
  }
}

TEST(ShortenToFitTest, IsEmptyWhereNotALetterFits) {
  EXPECT_EQ(ShortenToFit("score", kStyle, 3.0), "");
}

TEST(JoinToFitTest, DropsTheLastParts) {
  const std::vector<std::string> parts{"run", "step 3", "node (0, 2)"};
  EXPECT_EQ(JoinToFit(parts, kStyle, 1000.0), "run · step 3 · node (0, 2)");
  EXPECT_EQ(JoinToFit(parts, kStyle, TextWidth("run · step 3", kStyle) + 1.0), "run · step 3");
}

TEST(JoinToFitTest, ShortensTheFirstPartRatherThanSayingNothing) {
  const double width = TextWidth("a lon…", kStyle);
  EXPECT_EQ(JoinToFit({"a long name", "b"}, kStyle, width), "a lon…");
  EXPECT_EQ(JoinToFit({}, kStyle, width), "");
}

}  // namespace
}  // namespace loopscope
