// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/loop_judge.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;

/// Where local SLAM has the robot, which drifts by this on the way round.
const Pose2 kDrift(0.8, -0.5, 0.1);

/// A robot that goes five metres, a node each, as submap 0, and the same way again as submap 1.
GraphState TwiceTheSameWay() {
  GraphState graph;
  for (int i = 0; i < 10; ++i) {
    GraphNode node;
    const Pose2 global_from_node(i % 5, 0.0, 0.0);
    node.local_from_node = i < 5 ? global_from_node : kDrift * global_from_node;
    node.first_submap = SubmapId{i / 5};
    graph.nodes.push_back(node);
    graph.node_ways.push_back(i < 5 ? i : i + 100.0);
    graph.global_from_node.push_back(node.local_from_node);
  }
  for (int i = 0; i < 2; ++i) {
    GraphSubmap submap;
    submap.first_node = NodeId{5 * i};
    submap.num_nodes = 5;
    graph.submaps.push_back(submap);
    graph.global_from_submap.emplace_back();
  }
  return graph;
}

/// Of a node of the second time into submap 0, off by `error` from the truth.
LoopCandidate LoopOf(int node, const Pose2& error = Pose2()) {
  LoopCandidate loop;
  loop.submap = SubmapId{0};
  loop.node = NodeId{node};
  loop.verdict = Verdict::kAccepted;
  loop.min_score = 0.3;
  loop.score = 0.4;
  loop.submap_from_node = Pose2(node % 5, 0.0, 0.0) * error;
  return loop;
}

LoopConsistencyOptions Consistency(int min_num_supporters) {
  LoopConsistencyOptions options;
  options.min_num_supporters = min_num_supporters;
  return options;
}

OutlierOptions Outliers() {
  OutlierOptions options;
  options.max_distance = 0.3;
  return options;
}

std::vector<Verdict> VerdictsOn(const std::vector<LoopCandidate>& loops) {
  std::vector<Verdict> verdicts;
  for (const LoopCandidate& loop : loops) verdicts.push_back(loop.verdict);
  return verdicts;
}

TEST(LoopJudge, RejectsLoopsThatTooFewAgreeWith) {
  const LoopJudge judge(Consistency(2), Outliers());
  std::vector<LoopCandidate> loops = {LoopOf(5), LoopOf(6), LoopOf(7),
                                      LoopOf(8, Pose2(1.0, 0.0, 0.0))};
  judge.RejectInconsistent(TwiceTheSameWay(), &loops);
  EXPECT_THAT(VerdictsOn(loops), ElementsAre(Verdict::kAccepted, Verdict::kAccepted,
                                             Verdict::kAccepted, Verdict::kInconsistent));
  EXPECT_EQ(loops[0].num_supporters, 2);
  EXPECT_EQ(loops[3].num_supporters, 0);
}

TEST(LoopJudge, CountsOnlyAcceptedLoops) {
  const LoopJudge judge(Consistency(1), Outliers());
  std::vector<LoopCandidate> loops = {LoopOf(5), LoopOf(6)};
  loops[1].verdict = Verdict::kAmbiguous;
  judge.RejectInconsistent(TwiceTheSameWay(), &loops);
  EXPECT_THAT(VerdictsOn(loops), ElementsAre(Verdict::kInconsistent, Verdict::kAmbiguous));
}

TEST(LoopJudge, CountsLoopsThatWereBelievedBefore) {
  const GraphState graph = TwiceTheSameWay();
  LoopJudge judge(Consistency(2), Outliers());
  judge.Believe(graph, LoopOf(5));
  judge.Believe(graph, LoopOf(6));
  EXPECT_EQ(judge.num_believed(), 2u);
  std::vector<LoopCandidate> loops = {LoopOf(7)};
  judge.RejectInconsistent(graph, &loops);
  EXPECT_EQ(loops[0].verdict, Verdict::kAccepted);
}

TEST(LoopJudge, AsksForOneFewerWhereTheScoreIsGood) {
  LoopConsistencyOptions options = Consistency(1);
  options.good_score_ratio = 1.3;
  std::vector<LoopCandidate> loops = {LoopOf(5)};
  LoopJudge(options, Outliers()).RejectInconsistent(TwiceTheSameWay(), &loops);
  EXPECT_EQ(loops[0].verdict, Verdict::kAccepted);
}

TEST(LoopJudge, BelievesALastLookIfTheMapAgreesAndNotIfOtherLoopsDo) {
  const LoopJudge judge(Consistency(2), Outliers());
  const auto verdicts = [&](double map_is_off_by) {
    std::vector<LoopCandidate> loops = {LoopOf(5), LoopOf(6), LoopOf(7)};
    for (LoopCandidate& loop : loops) {
      loop.last_look = true;
      loop.submap_from_node_guess = loop.submap_from_node * Pose2(0.0, map_is_off_by, 0.0);
    }
    loops.push_back(LoopOf(8));
    loops.back().last_look = true;
    loops.back().submap_from_node_guess = loops.back().submap_from_node;
    judge.RejectInconsistent(TwiceTheSameWay(), &loops);
    return VerdictsOn(loops);
  };
  EXPECT_THAT(verdicts(0.29), Each(Verdict::kAccepted));
  EXPECT_THAT(verdicts(0.31), ElementsAre(Verdict::kInconsistent, Verdict::kInconsistent,
                                          Verdict::kInconsistent, Verdict::kAccepted));
}

TEST(LoopJudge, RejectsNothingIfNoSupportersAreAskedFor) {
  std::vector<LoopCandidate> loops = {LoopOf(5)};
  LoopJudge(Consistency(0), Outliers()).RejectInconsistent(TwiceTheSameWay(), &loops);
  EXPECT_EQ(loops[0].verdict, Verdict::kAccepted);
}

TEST(LoopJudge, TellsWhichLoopsStandAlone) {
  const LoopJudge judge(Consistency(1), Outliers());
  const std::vector<LoopCandidate> loops = {LoopOf(5), LoopOf(6), LoopOf(7, Pose2(0.0, 0.9, 0.0))};
  EXPECT_THAT(judge.LoneLoops(TwiceTheSameWay(), loops), ElementsAre(&loops[2]));
}

}  // namespace
}  // namespace loopscope
