// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/option_rows.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/option_values.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

constexpr const char* kMinScore = "POSE_GRAPH.constraint_builder.min_score";
constexpr const char* kNumRangeData = "TRAJECTORY_BUILDER_2D.submaps.num_range_data";

OptionEntry EntryOf(const Options& options, const std::string& key) {
  for (const OptionEntry& entry : OptionRows(options, LoopscopePreset())) {
    if (entry.key == key) return entry;
  }
  throw std::out_of_range(key);
}

TEST(OptionRows, HasEveryOptionInTheOrderOfTheTable) {
  Options options = LoopscopePreset();
  const std::vector<OptionRow> table = OptionTable(&options);
  const std::vector<OptionEntry> entries = OptionRows(options, LoopscopePreset());
  ASSERT_EQ(entries.size(), table.size());
  for (std::size_t i = 0; i < table.size(); ++i) {
    EXPECT_EQ(entries[i].key, table[i].key);
    EXPECT_EQ(entries[i].value, ToText(GetValue(table[i])));
    EXPECT_EQ(entries[i].unit, table[i].unit);
    EXPECT_EQ(entries[i].sentence, table[i].sentence);
    EXPECT_EQ(entries[i].expected, ExpectedValue(table[i]));
    EXPECT_FALSE(entries[i].changed);
  }
}

TEST(OptionRows, MarksWhatIsChangedFromThePreset) {
  Options options = LoopscopePreset();
  options.pose_graph.constraint_builder.min_score = 0.61;
  const OptionEntry changed = EntryOf(options, kMinScore);
  EXPECT_TRUE(changed.changed);
  EXPECT_EQ(changed.value, "0.61");
  EXPECT_EQ(changed.preset_value, "0.2");
  EXPECT_FALSE(EntryOf(options, kNumRangeData).changed);
}

}  // namespace
}  // namespace loopscope
