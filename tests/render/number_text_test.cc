// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/number_text.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(NumberTextTest, HasNoSignBeforeNothing) {
  EXPECT_EQ(FixedText(-0.04, 1), "0.0");
  EXPECT_EQ(FixedText(-0.06, 1), "-0.1");
  EXPECT_EQ(FixedText(-0.4, 0), "0");
  EXPECT_EQ(LengthText(-0.0004), "0.0 cm");
  EXPECT_EQ(AngleText(-1e-6), "0.00°");
}

TEST(NumberTextTest, TellsLengthsInCentimetresUpToAMetre) {
  EXPECT_EQ(LengthText(-0.123), "-12.3 cm");
  EXPECT_EQ(LengthText(4.561), "4.56 m");
}

TEST(NumberTextTest, TellsManyInMillions) {
  EXPECT_EQ(CountText(40817.0), "40817");
  EXPECT_EQ(CountText(8.451e6), "8.45 million");
}

}  // namespace
}  // namespace loopscope
