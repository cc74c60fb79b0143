// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/highlight.h"

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/slam/derive.h"
#include "render/views/grids.h"
#include "tests/support/mapped_log.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

/// The selection of a node and a submap after `step`; -1 is none, and the last step.
Highlight Select(int node, int submap, int step = -1) {
  DerivedCache cache(SmallLoop());
  const MapState state = StateAfterStep(SmallLoop(), step < 0 ? SmallLoop().num_steps() - 1 : step);
  ViewRequest request;
  if (node >= 0) request.node = NodeId{node};
  if (submap >= 0) request.submap = SubmapId{submap};
  return HighlightOf(SmallLoop(), request, state, PlacedGridsOf(&cache, state));
}

const LoopCandidate& CandidateOf(Verdict verdict) {
  const auto& candidates = SmallLoop().candidates();
  return *std::find_if(candidates.begin(), candidates.end(),
                       [&](const LoopCandidate& c) { return c.verdict == verdict; });
}

TEST(HighlightOfTest, HasNodeAndSubmapWhereTheStateHasThem) {
  const MapState state = StateAfterStep(SmallLoop(), SmallLoop().num_steps() - 1);
  const Highlight highlight = Select(5, 3);
  EXPECT_EQ(highlight.node, NodeId{5});
  EXPECT_EQ(highlight.node_place, state.global_from_node[5].translation);
  EXPECT_EQ(highlight.submap, SubmapId{3});
  EXPECT_EQ(highlight.global_from_submap, state.global_from_submap[3]);
}

TEST(HighlightOfTest, TheBoxOfASubmapHoldsItsKnownCells) {
  const Highlight highlight = Select(-1, 3);
  ASSERT_EQ(highlight.known_area.size(), 4u);
  const ProbabilityGrid grid = GridOfSubmap(SmallLoop(), SubmapId{3});
  const CellBox box = grid.box();
  const Pose2 submap_from_global = highlight.global_from_submap.Inverse();
  const Eigen::Vector2d min = submap_from_global * highlight.known_area[0];
  const Eigen::Vector2d max = submap_from_global * highlight.known_area[2];
  EXPECT_TRUE(min.isApprox(0.05 * Eigen::Vector2d(box.min.x - 0.5, box.min.y - 0.5), 1e-9));
  EXPECT_TRUE((max - min).isApprox(0.05 * Eigen::Vector2d(box.width, box.height), 1e-9));
}

TEST(HighlightOfTest, LeavesOutWhatDoesNotExistYet) {
  EXPECT_TRUE(Select(80, 9, 10).empty());
  EXPECT_TRUE(Select(-1, -1).empty());
  EXPECT_FALSE(Select(0, 9, 10).empty());
}

TEST(HighlightOfTest, RefusesWhatTheRecordingDoesNotHave) {
  EXPECT_THAT(MessageOf([] { Select(9999, -1); }), StartsWith("no node 9999: expected 0 to "));
  EXPECT_THAT(MessageOf([] { Select(-1, 9999); }), StartsWith("no submap 9999: expected 0 to "));
}

TEST(HighlightOfTest, LinksAPairThatIsSearchedTwiceByTheSearchUntilTheStep) {
  const auto& candidates = SmallLoop().candidates();
  const auto first = std::find_if(candidates.begin(), candidates.end(), [&](const auto& c) {
    const auto last = SmallLoop().FindCandidate(c.submap, c.node);
    return c.verdict != Verdict::kNotSampled && &candidates[*last] != &c;
  });
  ASSERT_NE(first, candidates.end());
  const int last = *SmallLoop().FindCandidate(first->submap, first->node);
  const auto text_of = [](const LoopCandidate& c) { return fmt::format("score {:.3f}", c.score); };
  ASSERT_NE(text_of(*first), text_of(candidates[last]));
  const auto link_text_at = [&](int step) {
    return Select(first->node.index, first->submap.index, step).link_text;
  };
  EXPECT_EQ(link_text_at(first->applied_step - 1), "");
  EXPECT_THAT(link_text_at(first->applied_step), HasSubstr(text_of(*first)));
  EXPECT_THAT(link_text_at(candidates[last].applied_step), HasSubstr(text_of(candidates[last])));
}

TEST(HighlightOfTest, LinksANodeToItsOwnSubmapByIntra) {
  const NodeId first = SmallLoop().submap(SubmapId{3}).first_node;
  const Highlight highlight = Select(first.index, 3);
  ASSERT_TRUE(highlight.link);
  EXPECT_EQ(highlight.link->constraint.tag, Constraint::Tag::kIntraSubmap);
  EXPECT_EQ(highlight.link->node, highlight.node_place);
  EXPECT_THAT(highlight.link_text, StartsWith("INTRA, residual "));
}

TEST(HighlightOfTest, LinksTheEndsOfALoopByInter) {
  const LoopCandidate& loop = CandidateOf(Verdict::kAccepted);
  const Highlight highlight = Select(loop.node.index, loop.submap.index);
  ASSERT_TRUE(highlight.link);
  EXPECT_EQ(highlight.link->constraint.tag, Constraint::Tag::kInterSubmap);
  EXPECT_TRUE(highlight.link->expected_node.isApprox(highlight.global_from_submap *
                                                     loop.submap_from_node.translation));
  EXPECT_THAT(highlight.link_text, StartsWith("INTER, score 0."));
  EXPECT_THAT(highlight.link_text, HasSubstr(", residual "));
}

TEST(HighlightOfTest, TellsOfASearchInVainThatItIsNoLoop) {
  const LoopCandidate& candidate = CandidateOf(Verdict::kBelowMinScore);
  const Highlight highlight = Select(candidate.node.index, candidate.submap.index);
  ASSERT_TRUE(highlight.link);
  EXPECT_THAT(highlight.link_text, StartsWith("no loop: below score, score 0."));
}

TEST(HighlightOfTest, HasTheLinksOfTheLoopsThatAreMarkedBesideIt) {
  const LoopCandidate& loop = CandidateOf(Verdict::kAccepted);
  DerivedCache cache(SmallLoop());
  ViewRequest request;
  request.marked = {{loop.node, loop.submap}};
  const auto highlight_after = [&](int step) {
    const MapState state = StateAfterStep(SmallLoop(), step);
    return HighlightOf(SmallLoop(), request, state, PlacedGridsOf(&cache, state));
  };
  const Highlight highlight = highlight_after(SmallLoop().num_steps() - 1);
  ASSERT_EQ(highlight.marked.size(), 1u);
  EXPECT_EQ(highlight.marked.front().constraint.node, loop.node);
  EXPECT_FALSE(highlight.empty());
  EXPECT_TRUE(highlight_after(loop.applied_step - 1).empty()) << "not yet known";
}

TEST(HighlightOfTest, HasNoLinkBeforeTheLoopWasApplied) {
  const LoopCandidate& loop = CandidateOf(Verdict::kAccepted);
  EXPECT_FALSE(Select(loop.node.index, loop.submap.index, loop.applied_step - 1).link);
}

TEST(LinksOfTest, AreThoseOfTheNodeAndThoseOfTheSubmap) {
  const MapState state = StateAfterStep(SmallLoop(), SmallLoop().num_steps() - 1);
  const auto intra =
      PlaceConstraints(ConstraintsOf(SmallLoop(), state), Constraint::Tag::kIntraSubmap, state);
  EXPECT_EQ(LinksOf(Select(-1, 3), intra).size(), 16u);
  EXPECT_EQ(LinksOf(Select(20, -1), intra).size(), 2u);
  EXPECT_TRUE(LinksOf(Highlight(), intra).empty());
}

}  // namespace
}  // namespace loopscope
