// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/table.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;

enum { kName, kLength };

/// Three rows: ("b", 2.0), ("a", unknown), (unknown, -0.001).
Table SmallTable() {
  Table table({{"name", "", Column::Kind::kText, 0, "A name."},
               {"length", "m", Column::Kind::kNumber, 2, "A length."}});
  table.AddRows(3);
  table.Set(0, kName, "b");
  table.Set(0, kLength, 2.0);
  table.Set(1, kName, "a");
  table.Set(2, kLength, -0.001);
  return table;
}

TEST(Table, HoldsWhatWasSetAndKnowsNothingElse) {
  const Table table = SmallTable();
  EXPECT_EQ(table.num_rows(), 3);
  EXPECT_EQ(table.At(0, kName), Cell("b"));
  EXPECT_EQ(table.At(0, kLength), Cell(2.0));
  EXPECT_EQ(table.At(1, kLength), Cell());
  EXPECT_EQ(table.At(2, kName), Cell());
  EXPECT_TRUE(table.IsKnown(2, kLength));
  EXPECT_FALSE(table.IsKnown(2, kName));
}

TEST(Table, ForgetsWhatIsSetToUnknown) {
  Table table = SmallTable();
  table.Set(0, kName, std::monostate());
  table.Set(0, kLength, std::monostate());
  EXPECT_FALSE(table.IsKnown(0, kName));
  EXPECT_FALSE(table.IsKnown(0, kLength));
}

TEST(Table, ShowsTheDigitsOfTheColumnAndNoMinusAtZero) {
  const Table table = SmallTable();
  EXPECT_EQ(table.Text(0, kLength), "2.00");
  EXPECT_EQ(table.Text(1, kLength), "");
  EXPECT_EQ(table.Text(2, kLength), "0.00");
  EXPECT_EQ(table.Text(1, kName), "a");
  EXPECT_EQ(table.Text(2, kName), "");
}

TEST(Table, ComparesByValueWithTheUnknownLast) {
  const Table table = SmallTable();
  EXPECT_GT(table.Compare(kName, 0, 1), 0);
  EXPECT_LT(table.Compare(kName, 1, 0), 0);
  EXPECT_EQ(table.Compare(kName, 1, 1), 0);
  EXPECT_LT(table.Compare(kName, 0, 2), 0);
  EXPECT_GT(table.Compare(kLength, 1, 0), 0);
  EXPECT_GT(table.Compare(kLength, 0, 2), 0);
  EXPECT_EQ(table.Compare(kLength, 1, 1), 0);
}

TEST(Table, KeepsATextThatOccursOftenOnce) {
  Table table = SmallTable();
  table.AddRows(1);
  table.Set(3, kName, "b");
  EXPECT_THAT(table.Words(kName), ElementsAre("b", "a"));
  EXPECT_THAT(table.WordIds(kName), ElementsAre(0, 1, -1, 0));
}

TEST(Table, FindsColumnsByNameAndNamesThemOtherwise) {
  const Table table = SmallTable();
  EXPECT_EQ(table.ColumnOf("length"), kLength);
  EXPECT_EQ(MessageOf([&] { table.ColumnOf("width"); }),
            "no column 'width': expected one of name, length");
  EXPECT_THROW(table.ColumnOf("width"), std::invalid_argument);
}

}  // namespace
}  // namespace loopscope
