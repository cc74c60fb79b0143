// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/derive.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/graph/graph_solver.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

/// A gate so narrow that some pairs are too far.
Options NarrowGateOptions() {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.max_constraint_distance = 1.0;
  // Neighbours that are checked are searched where another loop has them.
  options.pose_graph.constraint_builder.consistency.num_checked_neighbors = 0;
  return options;
}

bool WasSearched(const LoopCandidate& candidate) {
  return candidate.verdict != Verdict::kNotSampled;
}

bool LiesIn(const Submap& submap, int node) {
  return submap.first_node.index <= node && node < submap.first_node.index + submap.num_nodes;
}

void ExpectSameGrid(const ProbabilityGrid& a, const ProbabilityGrid& b) {
  const CellBox& box = a.box();
  EXPECT_TRUE(box == b.box());
  int num_different = 0;
  for (int y = box.min.y; y < box.min.y + box.height; ++y) {
    for (int x = box.min.x; x < box.min.x + box.width; ++x) {
      num_different += a.value({x, y}) != b.value({x, y}) ? 1 : 0;
    }
  }
  EXPECT_EQ(num_different, 0);
}

TEST(GridOfSubmap, IsTheGridThatLocalSlamFinished) {
  const Recording& recording = SmallLoopRun();
  LocalSlam local_slam(recording.log(), recording.options().trajectory_builder_2d);
  int num_finished = 0;
  for (int step = 0; step < recording.num_steps(); ++step) {
    const LocalSlamResult result = local_slam.AddScan(step);
    if (!result.insertion || !result.insertion->finished) continue;
    const ActiveSubmap& finished = *result.insertion->finished;
    SCOPED_TRACE(finished.id.index);
    EXPECT_EQ(recording.submap(finished.id).finished_step, step);
    ExpectSameGrid(GridOfSubmap(recording, finished.id), finished.grid);
    ++num_finished;
  }
  EXPECT_GT(num_finished, 10);
}

TEST(GridOfSubmap, GrowsNodeByNode) {
  const Recording& recording = SmallLoopRun();
  const SubmapId submap{2};
  EXPECT_TRUE(GridOfSubmap(recording, submap, 0).box().empty());
  ProbabilityGrid grid = GridOfSubmap(recording, submap, 4);
  const ScanInserter inserter(
      recording.options().trajectory_builder_2d.submaps.range_data_inserter);
  const NodeId fifth{recording.submap(submap).first_node.index + 4};
  inserter.Insert(CellsOfNode(recording, submap, fifth), &grid);
  ExpectSameGrid(GridOfSubmap(recording, submap, 5), grid);
}

TEST(GrowGrids, MakesThoseOfEachSubmapByItself) {
  const Recording& recording = SmallLoopRun();
  const SubmapId first{2};
  const std::vector<int> nums_nodes = {3, recording.submap(SubmapId{3}).num_nodes, 0, 5};
  std::vector<ProbabilityGrid> grids(4, GridOfSubmap(recording, first, 0));
  GrowGrids(recording, first, {0, 0, 0, 0}, nums_nodes, &grids);
  ASSERT_EQ(grids.size(), nums_nodes.size());
  for (int i = 0; i < 4; ++i) {
    SCOPED_TRACE(i);
    const SubmapId submap{first.index + i};
    ProbabilityGrid expected(grids[i].resolution());
    const ScanInserter inserter(
        recording.options().trajectory_builder_2d.submaps.range_data_inserter);
    for (int k = 0; k < nums_nodes[i]; ++k) {
      const NodeId node{recording.submap(submap).first_node.index + k};
      inserter.Insert(CellsOfNode(recording, submap, node), &expected);
    }
    ExpectSameGrid(grids[i], expected);
  }
}

TEST(NumNodesOfSubmapAfterStep, CountsTheNodesUntilThen) {
  const Recording& recording = SmallLoopRun();
  const SubmapId id{1};
  const Submap& submap = recording.submap(id);
  const int first_step = recording.node(submap.first_node).step;
  EXPECT_EQ(NumNodesOfSubmapAfterStep(recording, id, first_step - 1), 0);
  EXPECT_EQ(NumNodesOfSubmapAfterStep(recording, id, first_step), 1);
  EXPECT_EQ(NumNodesOfSubmapAfterStep(recording, id, submap.finished_step - 1), 15);
  EXPECT_EQ(NumNodesOfSubmapAfterStep(recording, id, submap.finished_step), 16);
  EXPECT_EQ(NumNodesOfSubmapAfterStep(recording, id, recording.num_steps() - 1), 16);
}

/// Whether the mapper searched the pair of the candidate, and did not look again later.
bool WasSearchedLast(const Recording& recording, const LoopCandidate& candidate) {
  const auto last = recording.FindCandidate(candidate.submap, candidate.node);
  return WasSearched(candidate) && &recording.candidates()[*last] == &candidate;
}

void ExpectSameCandidate(const LoopCandidate& a, const LoopCandidate& b) {
  EXPECT_EQ(a.submap, b.submap);
  EXPECT_EQ(a.node, b.node);
  EXPECT_EQ(a.considered_step, b.considered_step);
  EXPECT_EQ(a.submap_from_node_guess, b.submap_from_node_guess);
  EXPECT_EQ(a.linear_search_window, b.linear_search_window);
  EXPECT_EQ(a.angular_search_window, b.angular_search_window);
  EXPECT_EQ(a.min_score, b.min_score);
}

TEST(ReplaySearch, FindsForEverySearchWhatTheMapperFoundBitForBit) {
  const Recording& recording = SmallLoopRun();
  int num_searched = 0;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!WasSearchedLast(recording, candidate)) continue;
    SCOPED_TRACE(ToString(candidate.submap) + " " + ToString(candidate.node));
    const auto replay = ReplaySearch(recording, candidate.submap, candidate.node);
    ASSERT_TRUE(replay);
    EXPECT_TRUE(replay->recorded);
    ExpectSameCandidate(replay->result, candidate);
    EXPECT_EQ(replay->result.score, candidate.score);
    EXPECT_EQ(replay->result.score_bound, candidate.score_bound);
    EXPECT_EQ(replay->result.submap_from_node_searched, candidate.submap_from_node_searched);
    EXPECT_EQ(replay->result.submap_from_node, candidate.submap_from_node);
    EXPECT_EQ(replay->result.verdict == Verdict::kBelowMinScore,
              candidate.verdict == Verdict::kBelowMinScore);
    EXPECT_FALSE(replay->trace.nodes.empty());
    EXPECT_EQ(replay->trace.winner >= 0, candidate.verdict != Verdict::kBelowMinScore);
    ++num_searched;
  }
  EXPECT_GT(num_searched, 200);
}

TEST(GateOfPair, ExpectsNoDriftOfALastLook) {
  const Recording& recording = SmallLoopRun();
  const auto& candidates = recording.candidates();
  const auto last = std::find_if(candidates.begin(), candidates.end(),
                                 [](const auto& candidate) { return candidate.last_look; });
  ASSERT_NE(last, candidates.end());
  const LoopGate gate = GateOfPair(recording, last->submap, last->node);
  EXPECT_EQ(gate.way, 0.0);
  EXPECT_EQ(gate.linear_window, last->linear_search_window);
}

TEST(ReplaySearch, FindsWhatWasRejectedIfAskedForLess) {
  const Recording& recording = SmallLoopRun();
  const auto& candidates = recording.candidates();
  const auto below = std::find_if(candidates.begin(), candidates.end(), [](const auto& candidate) {
    return candidate.verdict == Verdict::kBelowMinScore;
  });
  ASSERT_NE(below, candidates.end());
  const auto replay = ReplaySearch(recording, below->submap, below->node, kMinProbability);
  EXPECT_EQ(replay->result.verdict, Verdict::kAccepted);
  EXPECT_GE(replay->result.score, below->score);
  EXPECT_LE(replay->result.score, below->score_bound);
}

TEST(ReplaySearch, SearchesWhatTheMapperDidNotSample) {
  const Recording& recording = SmallLoopRun();
  const auto& candidates = recording.candidates();
  const auto skipped = std::find_if(candidates.begin(), candidates.end(),
                                    [](const auto& c) { return !WasSearched(c); });
  ASSERT_NE(skipped, candidates.end());
  const auto replay = ReplaySearch(recording, skipped->submap, skipped->node);
  EXPECT_FALSE(replay->recorded);
  EXPECT_GT(replay->result.score, 0.0);
  ExpectSameCandidate(replay->candidate, ConsiderPair(recording, skipped->submap, skipped->node));
}

TEST(SearchWholeSubmap, LooksBeyondTheWindowOfTheMapper) {
  const Recording& recording = SmallLoopRun();
  int num_closed = 0;
  int num_beyond = 0;  // the corners of the loop look alike
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (candidate.verdict != Verdict::kAccepted) continue;
    ++num_closed;
    const auto found = SearchWholeSubmap(recording, candidate.submap, candidate.node);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->min_score,
              recording.options().pose_graph.constraint_builder.global_localization_min_score);
    if (!IsFound(found->verdict)) continue;           // by global_localization_min_score
    EXPECT_GE(found->score, candidate.score - 0.15);  // the lattice is another one
    const Pose2 guess_from_node =
        candidate.submap_from_node_guess.Inverse() * found->submap_from_node;
    num_beyond += std::abs(guess_from_node.rotation) > candidate.angular_search_window ? 1 : 0;
  }
  EXPECT_GT(num_closed, 10);
  EXPECT_GT(num_beyond, 0);
  EXPECT_FALSE(SearchWholeSubmap(recording, SubmapId{1}, NodeId{8}));
}

TEST(ReplaySearch, IsNothingForASubmapThatGrowsOrHoldsTheNode) {
  const Recording& recording = SmallLoopRun();
  const int newest = static_cast<int>(recording.submaps().size()) - 1;
  ASSERT_LT(recording.submaps()[newest].finished_step, 0);
  EXPECT_FALSE(ReplaySearch(recording, SubmapId{newest}, NodeId{0}));
  EXPECT_FALSE(ReplaySearch(recording, SubmapId{1}, NodeId{8}));
  EXPECT_FALSE(ReplaySearch(recording, SubmapId{1}, NodeId{23}));
  EXPECT_TRUE(ReplaySearch(recording, SubmapId{1}, NodeId{24}));
}

TEST(ReplaySearch, IsNothingForANodeWithoutPointsToSearchWith) {
  Options options = SmallLoopOptions();
  options.trajectory_builder_2d.loop_closure_adaptive_voxel_filter.max_range = 0.1;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  ASSERT_TRUE(recording.candidates().empty());
  EXPECT_FALSE(ReplaySearch(recording, SubmapId{0}, NodeId{100}));
}

TEST(ConsiderPair, SaysOfEverySearchWhatTheMapperWasAsked) {
  const Recording recording = MapLog(SimulateSmallLoop().log, NarrowGateOptions());
  int num_searched = 0;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!WasSearchedLast(recording, candidate)) continue;
    SCOPED_TRACE(ToString(candidate.submap) + " " + ToString(candidate.node));
    const LoopCandidate pair = ConsiderPair(recording, candidate.submap, candidate.node);
    ExpectSameCandidate(pair, candidate);
    EXPECT_EQ(pair.verdict, Verdict::kNotSampled);
    ++num_searched;
  }
  EXPECT_GT(num_searched, 50);
}

TEST(ConsiderPair, KnowsOfNodesThatMatchedNowhere) {
  ScanLog log = SimulateSmallLoop().log;
  for (int scan = 60; scan < 66; ++scan) SeePeopleAround(scan, &log.scans[scan]);
  const Recording recording = MapLog(log, NarrowGateOptions());
  ASSERT_TRUE(std::any_of(recording.nodes().begin(), recording.nodes().end(), [&](const Node& n) {
    return n.step >= 60 && MatchedNowhere(recording.step(n.step).match_start.value());
  }));
  double widest = 0.0;  // [m]
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!WasSearchedLast(recording, candidate)) continue;
    ExpectSameCandidate(ConsiderPair(recording, candidate.submap, candidate.node), candidate);
    widest = std::max(widest, candidate.linear_search_window);
  }
  EXPECT_GT(widest, 3.0) << "as after 100 m";
}

TEST(GateOfPair, IsOpenForExactlyThePairsThatCameUp) {
  const Recording recording = MapLog(SimulateSmallLoop().log, NarrowGateOptions());
  const auto came_up = [&](int submap, int node) {
    const auto& candidates = recording.candidates();
    return std::any_of(candidates.begin(), candidates.end(), [&](const LoopCandidate& c) {
      return c.submap.index == submap && c.node.index == node;
    });
  };
  int num_open = 0;
  int num_closed = 0;
  for (int submap = 0; submap < static_cast<int>(recording.submaps().size()); ++submap) {
    if (recording.submaps()[submap].finished_step < 0) continue;
    for (int node = submap % 3; node < static_cast<int>(recording.nodes().size()); node += 3) {
      if (LiesIn(recording.submaps()[submap], node)) continue;
      const bool open = GateOfPair(recording, SubmapId{submap}, NodeId{node}).is_near;
      EXPECT_EQ(open, came_up(submap, node)) << submap << " " << node;
      (open ? num_open : num_closed) += 1;
    }
  }
  EXPECT_GT(num_open, 50);
  EXPECT_GT(num_closed, 50);
}

TEST(ConstraintsOf, AreTheOnesThatTheLastOptimizationHeld) {
  const Recording& recording = SmallLoopRun();
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  GraphProblem problem{
      state.global_from_submap, state.global_from_node, ConstraintsOf(recording, state), {}};
  int num_inter = 0;
  int num_accepted = 0;
  for (const Constraint& constraint : problem.constraints) {
    num_inter += constraint.tag == Constraint::Tag::kInterSubmap ? 1 : 0;
  }
  for (const LoopCandidate& candidate : recording.candidates()) {
    num_accepted += candidate.verdict == Verdict::kAccepted ? 1 : 0;
  }
  EXPECT_EQ(num_inter, num_accepted);
  int num_insertions = 0;
  for (const Node& node : recording.nodes()) num_insertions += node.num_submaps;
  EXPECT_EQ(problem.constraints.size(), static_cast<std::size_t>(num_insertions + num_accepted));
  // With local SLAM between the nodes, which the state does not list, the poses are at a minimum.
  const OptimizationProblemOptions& options = recording.options().pose_graph.optimization_problem;
  for (std::size_t i = 1; i < recording.nodes().size(); ++i) {
    problem.consecutive_nodes.push_back(
        {NodeId{static_cast<int>(i) - 1}, NodeId{static_cast<int>(i)},
         recording.nodes()[i - 1].local_from_base.Inverse() * recording.nodes()[i].local_from_base,
         options.local_slam_pose_translation_weight, options.local_slam_pose_rotation_weight});
  }
  // The poses were rounded.
  EXPECT_NEAR(SolveGraph(problem, options, {0}).initial_cost,
              recording.optimizations().back().final_cost,
              1e-6 * recording.optimizations().back().final_cost);
}

}  // namespace
}  // namespace loopscope
