// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/charts/chart_ticks.h"

#include <gmock/gmock.h>

namespace loopscope {
namespace {

using testing::ElementsAre;

std::vector<std::string> LabelsOf(const ChartAxis& axis, int count) {
  std::vector<std::string> labels;
  for (const ChartTick& tick : TicksOf(axis, count)) labels.push_back(tick.label);
  return labels;
}

TEST(TicksOfTest, AreRoundAndInsideOfTheAxis) {
  EXPECT_THAT(
      LabelsOf({"", 0.0, 9246.0, false}, 5),
      ElementsAre("0", "1000", "2000", "3000", "4000", "5000", "6000", "7000", "8000", "9000"));
  EXPECT_THAT(LabelsOf({"", 0.1, 0.9, false}, 4), ElementsAre("0.2", "0.4", "0.6", "0.8"));
}

TEST(TicksOfTest, ArePowersOfTenOnALogarithmicAxis) {
  EXPECT_THAT(LabelsOf({"", 1e-3, 10.0, true}, 2), ElementsAre("0.001", "0.01", "0.1", "1", "10"));
}

}  // namespace
}  // namespace loopscope
