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

using testing::ElementsAre;
using testing::IsEmpty;
using testing::Optional;

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
    EXPECT_EQ(entries[i].minimum, table[i].minimum);
    EXPECT_EQ(entries[i].maximum, table[i].maximum);
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

TEST(OptionRows, TellsFlagsWholeNumbersAndNumbersApart) {
  EXPECT_EQ(EntryOf(Options(), "use_odometry").kind, OptionEntry::Kind::kFlag);
  EXPECT_EQ(EntryOf(Options(), kNumRangeData).kind, OptionEntry::Kind::kWholeNumber);
  EXPECT_EQ(EntryOf(Options(), kMinScore).kind, OptionEntry::Kind::kNumber);
}

TEST(WithEdits, SetsWhatWasTypedAndNothingElse) {
  const Options edited = WithEdits(
      LoopscopePreset(), {{kMinScore, " 0.7 "}, {kNumRangeData, "50"}, {"use_odometry", "false"}});
  EXPECT_EQ(edited.pose_graph.constraint_builder.min_score, 0.7);
  EXPECT_EQ(edited.trajectory_builder_2d.submaps.num_range_data, 50);
  EXPECT_FALSE(edited.trajectory_builder_2d.use_odometry);
  EXPECT_EQ(AssignmentsOf(edited, LoopscopePreset()).size(), 3u);
}

TEST(WithEdits, NamesKeyAndRangeOfWhatDoesNotFit) {
  const auto message_of = [](const OptionEdit& edit) {
    return MessageOf([&] { WithEdits(LoopscopePreset(), {edit}); });
  };
  EXPECT_EQ(message_of({kMinScore, "2"}),
            "POSE_GRAPH.constraint_builder.min_score = 2: expected a number from 0 to 1");
  EXPECT_EQ(message_of({kNumRangeData, "many"}),
            "TRAJECTORY_BUILDER_2D.submaps.num_range_data = \"many\": expected a whole number from "
            "1 to 1000000");
  EXPECT_EQ(message_of({"use_odometrie", "true"}),
            "unknown option \"use_odometrie\"; did you mean use_odometry?");
  EXPECT_THROW(WithEdits(LoopscopePreset(), {{kMinScore, "2"}}), std::invalid_argument);
}

TEST(ErrorOf, TellsWhetherAnEditMayBeMade) {
  EXPECT_EQ(ErrorOf({kMinScore, "0.5"}), std::nullopt);
  EXPECT_THAT(ErrorOf({kMinScore, "2"}),
              Optional(std::string("POSE_GRAPH.constraint_builder.min_score = 2: expected a number "
                                   "from 0 to 1")));
}

TEST(AssignmentsOf, MakesTheOptionsOfThePresetAgain) {
  EXPECT_THAT(AssignmentsOf(LoopscopePreset(), LoopscopePreset()), IsEmpty());
  const Options edited = WithEdits(LoopscopePreset(), {{kMinScore, "0.123456789012345"}});
  EXPECT_THAT(AssignmentsOf(edited, LoopscopePreset()),
              ElementsAre(std::string(kMinScore) + "=0.123456789012345"));
  Options cartographer = LoopscopePreset();
  for (const auto& assignment : AssignmentsOf(CartographerPreset(), LoopscopePreset())) {
    SetFromAssignment(assignment, &cartographer);
  }
  EXPECT_EQ(OptionsToText(cartographer), OptionsToText(CartographerPreset()));
}

}  // namespace
}  // namespace loopscope
