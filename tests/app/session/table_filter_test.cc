// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/table_filter.h"

#include <ostream>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

enum { kNode, kScore, kScoreBound, kVerdict, kReason };

/// Row, node, score, bound, verdict:
///   0   5   0.7004   0.9   closed
///   1   3   0.5      0.6   Not sampled (reason: skipped, twice)
///   2   5   -        -     -
///   3   4   0.7      0.6   below score
Table SmallTable() {
  Table table({{"node", "", Column::Kind::kNumber, 0, ""},
               {"score", "", Column::Kind::kNumber, 3, ""},
               {"score_bound", "", Column::Kind::kNumber, 3, ""},
               {"verdict", "", Column::Kind::kText, 0, ""},
               {"reason", "", Column::Kind::kText, 0, ""}});
  table.AddRows(4);
  const double nodes[] = {5, 3, 5, 4};
  for (int row = 0; row < 4; ++row) table.Set(row, kNode, nodes[row]);
  table.Set(0, kScore, 0.7004);
  table.Set(1, kScore, 0.5);
  table.Set(3, kScore, 0.7);
  table.Set(0, kScoreBound, 0.9);
  table.Set(1, kScoreBound, 0.6);
  table.Set(3, kScoreBound, 0.6);
  table.Set(0, kVerdict, "closed");
  table.Set(1, kVerdict, "Not sampled");
  table.Set(3, kVerdict, "below score");
  table.Set(1, kReason, "skipped, twice");
  return table;
}

std::vector<int> Filtered(const std::string& text) {
  const Table table = SmallTable();
  return RowsOf(table, TableFilter(text, table.columns()));
}

TEST(TableFilter, LetsAllRowsThroughIfBlank) {
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter()), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(Filtered(""), ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(Filtered(" \t "), ElementsAre(0, 1, 2, 3));
}

TEST(TableFilter, ComparesNumbers) {
  EXPECT_THAT(Filtered("node < 4"), ElementsAre(1));
  EXPECT_THAT(Filtered("node <= 4"), ElementsAre(1, 3));
  EXPECT_THAT(Filtered("node > 4"), ElementsAre(0, 2));
  EXPECT_THAT(Filtered("node >= 4"), ElementsAre(0, 2, 3));
  EXPECT_THAT(Filtered("node = 5"), ElementsAre(0, 2));
  EXPECT_THAT(Filtered("node == 5"), ElementsAre(0, 2));
  EXPECT_THAT(Filtered("node != 5"), ElementsAre(1, 3));
  EXPECT_THAT(Filtered("node>-1e3"), ElementsAre(0, 1, 2, 3));
}

TEST(TableFilter, TakesNumbersAsEqualWithinHalfOfTheLastDigitShown) {
  EXPECT_THAT(Filtered("score = 0.7"), ElementsAre(0, 3));
  EXPECT_THAT(Filtered("score != 0.7"), ElementsAre(1));
  EXPECT_THAT(Filtered("score = 0.7007"), ElementsAre(0));
  EXPECT_THAT(Filtered("score = 0.6994"), IsEmpty());
  EXPECT_THAT(Filtered("node = 4.4"), IsEmpty());
}

TEST(TableFilter, RangesIncludeTheirEnds) {
  EXPECT_THAT(Filtered("score 0.5..0.7"), ElementsAre(1, 3));
  EXPECT_THAT(Filtered("node 3..4"), ElementsAre(1, 3));
  EXPECT_THAT(Filtered("node -1..+3 and score .4...6"), ElementsAre(1));
}

TEST(TableFilter, ComparesTextsAsAWholeWithoutCase) {
  EXPECT_THAT(Filtered("verdict = CLOSED"), ElementsAre(0));
  EXPECT_THAT(Filtered("verdict = sampled"), IsEmpty());
  EXPECT_THAT(Filtered("verdict = \"not sampled\""), ElementsAre(1));
  EXPECT_THAT(Filtered("verdict != 'not sampled'"), ElementsAre(0, 3));
  EXPECT_THAT(Filtered("verdict=closed"), ElementsAre(0));
}

TEST(TableFilter, FindsBareTextsInAnyColumnOfText) {
  EXPECT_THAT(Filtered("lose"), ElementsAre(0));
  EXPECT_THAT(Filtered("score"), ElementsAre(3));
  EXPECT_THAT(Filtered("'TWICE'"), ElementsAre(1));
  EXPECT_THAT(Filtered("sampled twice"), ElementsAre(1));
  EXPECT_THAT(Filtered("sampled closed"), IsEmpty());
  EXPECT_THAT(Filtered("5"), IsEmpty());
  EXPECT_THAT(Filtered("'and'"), IsEmpty());
}

TEST(TableFilter, AndBindsTighterThanOrAndNotTightest) {
  EXPECT_THAT(Filtered("node = 5 or node = 3 and score > 0.6"), ElementsAre(0, 2));
  EXPECT_THAT(Filtered("(node = 5 or node = 3) and score > 0.6"), ElementsAre(0));
  EXPECT_THAT(Filtered("not node = 5 and score > 0.6"), ElementsAre(3));
  EXPECT_THAT(Filtered("NOT (node = 5 AND score > 0.6)"), ElementsAre(1, 2, 3));
  EXPECT_THAT(Filtered("not not closed Or node = 3"), ElementsAre(0, 1));
  EXPECT_THAT(Filtered("closed or node = 4 and not score < 0.6"), ElementsAre(0, 3));
}

TEST(TableFilter, AComparisonWithAnUnknownValueIsFalse) {
  EXPECT_THAT(Filtered("score < 9"), ElementsAre(0, 1, 3));
  EXPECT_THAT(Filtered("score != 9"), ElementsAre(0, 1, 3));
  EXPECT_THAT(Filtered("verdict != closed"), ElementsAre(1, 3));
  EXPECT_THAT(Filtered("not score < 9"), ElementsAre(2));
}

TEST(TableFilter, FindsColumnsByTheBeginningOfTheirNames) {
  EXPECT_THAT(Filtered("v = closed"), ElementsAre(0));
  EXPECT_THAT(Filtered("NODE = 3"), ElementsAre(1));
  EXPECT_THAT(Filtered("score_b > 0.8"), ElementsAre(0));
  EXPECT_THAT(Filtered("score > 0.8"), IsEmpty());
}

struct BadFilter {
  const char* text;
  const char* error;  ///< behind "filter, position "
};

void PrintTo(const BadFilter& filter, std::ostream* stream) { *stream << filter.text; }

class BadFilterTest : public testing::TestWithParam<BadFilter> {};

TEST_P(BadFilterTest, IsRefusedWithPositionAndWhatWasExpected) {
  EXPECT_EQ(MessageOf([] { Filtered(GetParam().text); }),
            std::string("filter, position ") + GetParam().error);
  EXPECT_THROW(Filtered(GetParam().text), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(
    All, BadFilterTest,
    testing::Values(
        BadFilter{"scroe > 1", "1: column 'scroe' does not exist; did you mean 'score'?"},
        BadFilter{"closed and ndoe = 1", "12: column 'ndoe' does not exist; did you mean 'node'?"},
        BadFilter{"scor > 1", "1: column 'scor' may be score, score_bound: expected more letters"},
        BadFilter{"score >", "8: expected a number to compare 'score' with instead of the end"},
        BadFilter{"score > high", "9: expected a number to compare 'score' with instead of 'high'"},
        BadFilter{"score > '1'", "9: expected a number to compare 'score' with instead of '1'"},
        BadFilter{"score > nan", "9: expected a number to compare 'score' with instead of 'nan'"},
        BadFilter{"score < inf", "9: expected a number to compare 'score' with instead of 'inf'"},
        BadFilter{"score > 1x", "9: expected a number to compare 'score' with instead of '1x'"},
        BadFilter{"score > > 1", "9: expected a number to compare 'score' with instead of '>'"},
        BadFilter{"score ! 1", "7: expected '!=' instead of '!'"},
        BadFilter{"score =< 1", "8: expected a number to compare 'score' with instead of '<'"},
        BadFilter{"score 0.5",
                  "7: expected a comparison such as '=' after column 'score' instead "
                  "of '0.5'"},
        BadFilter{"score 0.7..0.5", "7: expected a range such as 0.5..0.7 instead of '0.7..0.5'"},
        BadFilter{"score 0.7..", "7: expected a range such as 0.5..0.7 instead of '0.7..'"},
        BadFilter{"score ..", "7: expected a range such as 0.5..0.7 instead of '..'"},
        BadFilter{"score 1..x", "7: expected a range such as 0.5..0.7 instead of '1..x'"},
        BadFilter{"verdict 1..2",
                  "9: expected '=' or '!=' after the column of text 'verdict' "
                  "instead of '1..2'"},
        BadFilter{"verdict > closed",
                  "9: expected '=' or '!=' after the column of text 'verdict' "
                  "instead of '>'"},
        BadFilter{"verdict =", "10: expected a text instead of the end"},
        BadFilter{"verdict = )", "11: expected a text instead of ')'"},
        BadFilter{"verdict = 'closed", "11: expected another ' to close the quote"},
        BadFilter{"\"", "1: expected another \" to close the quote"},
        BadFilter{"and", "1: expected a column, a text or '(' instead of 'and'"},
        BadFilter{"closed or", "10: expected a column, a text or '(' instead of the end"},
        BadFilter{"closed and and", "12: expected a column, a text or '(' instead of 'and'"},
        BadFilter{"not", "4: expected a column, a text or '(' instead of the end"},
        BadFilter{"()", "2: expected a column, a text or '(' instead of ')'"},
        BadFilter{"(closed", "8: expected ')' instead of the end"},
        BadFilter{"closed)", "7: expected 'and' or 'or' instead of ')'"},
        BadFilter{"> 1", "1: expected a column, a text or '(' instead of '>'"},
        BadFilter{"'score' > 1", "9: expected a column, a text or '(' instead of '>'"},
        BadFilter{"score > 1 > 0", "11: expected a column, a text or '(' instead of '>'"}));

TEST(TableFilter, RefusesToNestWithoutEnd) {
  EXPECT_THAT(Filtered(std::string(99, '(') + "closed" + std::string(99, ')')), ElementsAre(0));
  EXPECT_EQ(MessageOf([] { Filtered(std::string(100000, '(')); }),
            "filter, position 101: expected at most 100 nested terms");
  std::string nots;
  for (int i = 0; i < 100000; ++i) nots += "not ";
  EXPECT_THROW(Filtered(nots), std::invalid_argument);
}

TEST(RowsOf, SortsByNumbersWithTheUnknownLastInBothDirections) {
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kScore), ElementsAre(1, 3, 0, 2));
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kScore, true), ElementsAre(0, 3, 1, 2));
}

TEST(RowsOf, SortsByTextsWithTheUnknownLastInBothDirections) {
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kVerdict), ElementsAre(1, 3, 0, 2));
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kVerdict, true), ElementsAre(0, 3, 1, 2));
}

TEST(RowsOf, RowsThatAreAlikeKeepTheirOrder) {
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kNode), ElementsAre(1, 3, 0, 2));
  EXPECT_THAT(RowsOf(SmallTable(), TableFilter(), kNode, true), ElementsAre(0, 2, 3, 1));
}

TEST(RowsOf, SortsOnlyWhatGoesThroughTheFilter) {
  const Table table = SmallTable();
  EXPECT_THAT(RowsOf(table, TableFilter("score > 0.1", table.columns()), kScoreBound),
              ElementsAre(1, 3, 0));
}

}  // namespace
}  // namespace loopscope
