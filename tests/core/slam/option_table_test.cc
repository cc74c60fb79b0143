// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/option_table.h"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/option_values.h"

namespace loopscope {
namespace {

// The address of the field and the bytes that it takes.
std::pair<const char*, size_t> Place(const OptionRow& row) {
  return std::visit(
      [](auto* field) {
        return std::make_pair(reinterpret_cast<const char*>(field), sizeof(*field));
      },
      row.field);
}

TEST(OptionTable, HasNoKeyAndNoFieldTwice) {
  Options options;
  std::set<std::string> keys;
  std::set<const char*> fields;
  for (const OptionRow& row : OptionTable(&options)) {
    EXPECT_TRUE(keys.insert(row.key).second) << row.key;
    EXPECT_TRUE(fields.insert(Place(row).first).second) << row.key;
  }
}

TEST(OptionTable, HasSentencesThatNeedNoOther) {
  Options options;
  for (const OptionRow& row : OptionTable(&options)) {
    EXPECT_THAT(row.sentence, testing::MatchesRegex("[A-Z].*\\.")) << row.key;
    for (const std::string word : {"Likewise", "And ", "But ", "Such "}) {
      EXPECT_NE(row.sentence.rfind(word, 0), 0u) << row.key << ": " << row.sentence;
    }
  }
}

TEST(OptionTable, CoversEveryFieldOfTheOptions) {
  // No member is larger than 8 bytes, so a larger gap than that is a field without a row.
  Options options;
  std::vector<bool> covered(sizeof(Options), false);
  for (const OptionRow& row : OptionTable(&options)) {
    const auto [address, size] = Place(row);
    const auto offset = address - reinterpret_cast<const char*>(&options);
    ASSERT_GE(offset, 0);
    ASSERT_LE(offset + size, sizeof(Options));
    for (size_t i = 0; i < size; ++i) covered[offset + i] = true;
  }
  for (size_t i = 0; i < sizeof(Options); i += 8) {
    EXPECT_TRUE(covered[i]) << "no row for the field at byte " << i;
  }
}

TEST(OptionTable, SaysWhatEachOptionIsAndMayBe) {
  Options options;
  for (const OptionRow& row : OptionTable(&options)) {
    EXPECT_EQ(row.sentence.back(), '.') << row.key;
    if (std::holds_alternative<bool*>(row.field)) continue;
    EXPECT_LT(row.minimum, row.maximum) << row.key;
  }
}

}  // namespace
}  // namespace loopscope
