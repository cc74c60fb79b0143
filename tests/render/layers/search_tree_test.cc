// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/search_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

using testing::ElementsAre;

SearchNode Node(int height, CellIndex offset, int angle, double bound, SearchFate fate) {
  SearchNode node;
  node.height = height;
  node.offset = offset;
  node.angle_index = angle;
  node.bound = bound;
  node.fate = fate;
  return node;
}

/// A window of 2 cells each way around (1, 1), two blocks at height 2 and leaves in one of them.
SearchTrace SmallTrace() {
  SearchTrace trace;
  trace.window = {Pose2(1.0, 1.0, 0.0), 2, 1, 0.1, 0.01};
  trace.nodes = {Node(2, {-2, -2}, 0, 0.8, SearchFate::kExpanded),
                 Node(2, {-2, -2}, 1, 0.9, SearchFate::kPruned),
                 Node(2, {2, -2}, 0, 0.4, SearchFate::kPruned),
                 Node(2, {2, -2}, 1, 0.5, SearchFate::kPruned),
                 Node(0, {-2, -2}, 0, 0.7, SearchFate::kImproved),
                 Node(0, {-1, -2}, 0, 0.6, SearchFate::kPruned)};
  trace.nodes[4].parent = trace.nodes[5].parent = 0;
  trace.visits = {0, 4, 5, 1, 3, 2};
  trace.winner = 4;
  return trace;
}

TEST(LevelsOfTest, CountsFatesFromTheTopDown) {
  const auto levels = LevelsOf(SearchPart(SmallTrace()));
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[0].height, 2);
  EXPECT_EQ(levels[0].num_scored, 4);
  EXPECT_EQ(levels[0].num_expanded, 1);
  EXPECT_EQ(levels[1].height, 0);
  EXPECT_EQ(levels[1].num_expanded, 1);
}

TEST(LevelsOfTest, ShowsExpandedBeforePrunedAndThenTheHighestBound) {
  EXPECT_THAT(LevelsOf(SearchPart(SmallTrace()))[0].shown, ElementsAre(0, 3));
}

TEST(LevelsOfTest, OfAPartHaveOnlyWhatWasScoredUntilThen) {
  const SearchTrace trace = SmallTrace();
  const auto before = LevelsOf(SearchPart(trace, {0, {}, {}}));
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[0].num_scored, 4);
  EXPECT_EQ(before[0].num_expanded, 0);
  EXPECT_THAT(before[0].shown, ElementsAre(1, 3));
  EXPECT_TRUE(before[1].shown.empty());
  const auto after = LevelsOf(SearchPart(trace, {2, {}, {}}));
  EXPECT_EQ(after[0].num_expanded, 1);
  EXPECT_THAT(after[0].shown, ElementsAre(0, 3));
  EXPECT_EQ(after[1].num_expanded, 1);
}

TEST(LevelsOfTest, ABlockThatWaitsComesBeforeAPrunedOne) {
  const SearchTrace trace = SmallTrace();
  EXPECT_THAT(LevelsOf(SearchPart(trace, {5, {}, {}}))[0].shown, ElementsAre(0, 2));
}

TEST(LevelsOfTest, HaveTheHeightAndTheAngleAskedFor) {
  const SearchTrace trace = SmallTrace();
  const auto levels = LevelsOf(SearchPart(trace, {{}, 2, 1}));
  ASSERT_EQ(levels.size(), 1u);
  EXPECT_EQ(levels[0].height, 2);
  EXPECT_THAT(levels[0].shown, ElementsAre(1, 3));
}

TEST(ExtentOfHeightTest, HoldsAllBlocksOfTheHeight) {
  const SearchTrace trace = SmallTrace();
  EXPECT_TRUE(ExtentOfHeight(trace, 2).isApprox(
      BlockOf(trace.nodes[0], trace.window).merged(BlockOf(trace.nodes[2], trace.window))));
  EXPECT_TRUE(ExtentOfHeight(trace, 1).isEmpty());
}

TEST(PrunedBlocksTest, AreThoseOfTheLevelThatWerePruned) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace);
  const auto blocks = PrunedBlocks(part, LevelsOf(part)[0]);
  ASSERT_EQ(blocks.size(), 1u);
  EXPECT_TRUE(blocks[0].isApprox(BlockOf(trace.nodes[3], trace.window)));
  EXPECT_EQ(PrunedFields(part, 3.0).size(), 1u);
  const SearchPart before(trace, {0, {}, {}});
  EXPECT_TRUE(PrunedBlocks(before, LevelsOf(before)[0]).empty());
  EXPECT_TRUE(PrunedFields(before, 3.0).empty());
}

TEST(BlockOfTest, CoversThePosesOfTheBlockCellByCell) {
  const SearchTrace trace = SmallTrace();
  const Extent block = BlockOf(trace.nodes[0], trace.window);
  EXPECT_TRUE(block.min().isApprox(Eigen::Vector2d(0.75, 0.75)));
  EXPECT_TRUE(block.max().isApprox(Eigen::Vector2d(1.15, 1.15)));
  const Extent leaf = BlockOf(trace.nodes[4], trace.window);
  EXPECT_NEAR(leaf.sizes().x(), 0.1, 1e-12);
}

TEST(WindowExtentTest, IsCenteredOnTheGuess) {
  const Extent window = WindowExtent(SmallTrace().window);
  EXPECT_TRUE(window.center().isApprox(Eigen::Vector2d(1.0, 1.0)));
  EXPECT_NEAR(window.sizes().x(), 0.5, 1e-12);
}

TEST(BoundRangeTest, SpansAllBoundsAndWhatTheyMustBeat) {
  const BoundRange range = BoundRangeOf(SmallTrace(), 0.5);
  EXPECT_DOUBLE_EQ(range.low, 0.4);
  EXPECT_DOUBLE_EQ(range.high, 0.9);
  EXPECT_DOUBLE_EQ(range.PlaceOf(0.65), 0.5);
  EXPECT_DOUBLE_EQ(BoundRangeOf(SmallTrace(), 0.95).PlaceOf(0.95), 1.0);
  EXPECT_DOUBLE_EQ(BoundRangeOf(SmallTrace(), 0.3).PlaceOf(0.3), 0.0);
  EXPECT_GT(BoundRangeOf({}, 0.5).high, BoundRangeOf({}, 0.5).low);
}

TEST(BlocksLayerTest, FillsOneSquareABlockAndFadesThePruned) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace);
  const Palette& palette = PaletteOf(Theme::kDefault);
  const auto layer = BlocksLayer(part, LevelsOf(part)[0], BoundRangeOf(trace, 0.5), palette);
  EXPECT_EQ(DataOf(layer)->GetNumberOfPolys(), 2);
  EXPECT_EQ(ColorOf(layer, 0), palette.bound.At(0.8));
  EXPECT_LT(ColorOf(layer, 4).a, 128);
}

TEST(ExpandedLayerTest, OutlinesOnlyWhatWasExpanded) {
  const SearchTrace trace = SmallTrace();
  const SearchPart part(trace);
  const auto layer = ExpandedLayer(part, LevelsOf(part)[0], 1.0, PaletteOf(Theme::kDefault));
  EXPECT_EQ(DataOf(layer)->GetNumberOfLines(), 1);
  EXPECT_TRUE(PointOf(layer, 0).isApprox(Eigen::Vector2d(0.75, 0.75), 1e-6));
}

TEST(AnglesLayerTest, HasAFieldForEachAngleAndHeightThatSaysMost) {
  const SearchTrace trace = SmallTrace();  // 3 angles, heights up to 2
  const Palette& palette = PaletteOf(Theme::kDefault);
  const auto layer = AnglesLayer(SearchPart(trace), BoundRangeOf(trace, 0.5), 3.0, palette);
  ASSERT_EQ(DataOf(layer)->GetNumberOfPolys(), 3);  // (0, 0), (0, 2), (1, 2)
  EXPECT_EQ(ColorOf(layer, 0), palette.bound.At(BoundRangeOf(trace, 0.5).PlaceOf(0.7)));
  EXPECT_EQ(ColorOf(layer, 4), palette.bound.At(BoundRangeOf(trace, 0.5).PlaceOf(0.8)));
  EXPECT_EQ(ColorOf(layer, 8), WithOpacity(palette.bound.At(1.0), kPrunedOpacity));
}

TEST(AnglesLayerTest, PutsFieldsSideBySideFromTheLowestAngleAndHeight) {
  const SearchTrace trace = SmallTrace();
  const Extent low = FieldOf(trace.nodes[4], trace, 3.0);
  EXPECT_TRUE(low.center().isApprox(Eigen::Vector2d(1.5, 0.25)));
  EXPECT_TRUE(low.sizes().isApprox(Eigen::Vector2d(1.0, 0.5)));
  const Extent high = FieldOf(trace.nodes[1], trace, 3.0);
  EXPECT_TRUE(high.center().isApprox(Eigen::Vector2d(2.5, 0.75)));
  SearchTrace unbranched = trace;
  unbranched.nodes.resize(1);
  EXPECT_TRUE(
      FieldOf(unbranched.nodes[0], unbranched, 3.0).sizes().isApprox(Eigen::Vector2d(1, 1)));
  const Extent column = ColumnOf(1, trace, 3.0);
  EXPECT_TRUE(column.min().isApprox(Eigen::Vector2d(2.0, 0.0)));
  EXPECT_TRUE(column.max().isApprox(Eigen::Vector2d(3.0, 1.0)));
}

}  // namespace
}  // namespace loopscope
