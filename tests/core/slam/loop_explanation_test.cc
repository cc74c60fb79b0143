// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/loop_explanation.h"

#include <algorithm>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

const Recording& SmallLoop() {
  static const Recording* const recording =
      new Recording(MapLog(SimulateSmallLoop().log, SmallLoopOptions()));
  return *recording;
}

const LoopCandidate& FirstWith(const Recording& recording, Verdict verdict) {
  const auto found =
      std::find_if(recording.candidates().begin(), recording.candidates().end(),
                   [&](const LoopCandidate& candidate) { return candidate.verdict == verdict; });
  EXPECT_NE(found, recording.candidates().end());
  return *found;
}

LoopExplanation ExplainFirstWith(const Recording& recording, Verdict verdict) {
  const LoopCandidate& candidate = FirstWith(recording, verdict);
  return ExplainLoop(recording, candidate.submap, candidate.node);
}

bool AllPassed(const LoopExplanation& explanation) {
  return std::all_of(explanation.checks.begin(), explanation.checks.end(),
                     [](const LoopCheck& check) { return check.passed; });
}

TEST(ExplainLoop, PassesEveryCheckOfALoopThatWasClosed) {
  const LoopExplanation explanation = ExplainFirstWith(SmallLoop(), Verdict::kAccepted);
  EXPECT_TRUE(explanation.closed);
  EXPECT_TRUE(AllPassed(explanation));
  EXPECT_THAT(explanation.answer, HasSubstr("Closed"));
  EXPECT_EQ(explanation.checks.back().what, "residual at the end");
}

TEST(ExplainLoop, TellsOfALoopThatWasLeftOutAtTheEnd) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimization_problem.outliers.max_distance = 0.002;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  int num_left_out = 0;
  for (const LoopCandidate& loop : recording.candidates()) {
    if (loop.verdict != Verdict::kAccepted) continue;
    const LoopExplanation explanation = ExplainLoop(recording, loop.submap, loop.node);
    const bool is_held = LoopResidual(state, loop).head<2>().norm() <= 0.002;
    EXPECT_EQ(explanation.closed, is_held);
    EXPECT_EQ(explanation.checks.back().what, "residual at the end");
    EXPECT_EQ(explanation.checks.back().passed, is_held);
    EXPECT_EQ(explanation.checks.back().expected, "at most 0.002 m, 3.00 deg");
    if (is_held) continue;
    EXPECT_THAT(explanation.answer, StartsWith("Left out at the end"));
    ++num_left_out;
  }
  EXPECT_GT(num_left_out, 0);
}

TEST(ReasonOf, TellsWhichRuleRefusedALoop) {
  LoopCandidate loop;
  loop.verdict = Verdict::kAmbiguous;
  EXPECT_THAT(ReasonOf(loop), HasSubstr("beyond the window"));
  loop.rival_score = 0.5;
  EXPECT_THAT(ReasonOf(loop), HasSubstr("at another place"));
  loop.verdict = Verdict::kInconsistent;
  EXPECT_THAT(ReasonOf(loop), HasSubstr("loops of other nodes"));
  loop.last_look = true;
  EXPECT_THAT(ReasonOf(loop), HasSubstr("the optimized map"));
}

TEST(ExplainLoop, TellsByHowMuchTheWindowWasNarrowed) {
  const auto num_narrowed = [](double min_window_share) {
    Options options = SmallLoopOptions();
    options.pose_graph.constraint_builder.measured_drift.min_window_share = min_window_share;
    const Recording recording = MapLog(SimulateSmallLoop().log, options);
    int count = 0;
    for (const LoopCandidate& candidate : recording.candidates()) {
      if (candidate.verdict != Verdict::kAccepted) continue;
      for (const LoopCheck& check :
           ExplainLoop(recording, candidate.submap, candidate.node).checks) {
        if (check.what != "search window") continue;
        EXPECT_THAT(check.value, HasSubstr(": 40 % and "));
        ++count;
      }
    }
    return count;
  };
  EXPECT_GT(num_narrowed(0.4), 0);
  EXPECT_EQ(num_narrowed(1.0), 0);
}

TEST(ExplainLoop, EndsWithTheScoreWhereItWasTooLow) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.min_score = 0.85;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  const LoopExplanation explanation = ExplainFirstWith(recording, Verdict::kBelowMinScore);
  EXPECT_FALSE(explanation.closed);
  EXPECT_EQ(explanation.checks.back().what, "score");
  EXPECT_FALSE(explanation.checks.back().passed);
  EXPECT_EQ(explanation.checks.back().expected, "more than 0.850");
}

/// Of each tenth node that found nothing in a small window, and what came of its last search.
template <typename Action>
void ForSomeBelowMinScore(const Recording& recording, const Action& action) {
  for (std::size_t i = 0; i < recording.candidates().size(); ++i) {
    const LoopCandidate& pair = recording.candidates()[i];
    if (pair.verdict != Verdict::kBelowMinScore || pair.node.index % 10 != 0) continue;
    if (static_cast<int>(i) != recording.FindCandidate(pair.submap, pair.node)) continue;
    const LoopExplanation explanation = ExplainLoop(recording, pair.submap, pair.node);
    ASSERT_TRUE(explanation.best_in_window);
    action(pair, explanation);
  }
}

Recording SmallLoopWithSmallWindows() {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.fast_correlative_scan_matcher.linear_search_window = 0.2;
  options.pose_graph.constraint_builder.linear_search_window_per_meter = 0.0;
  options.pose_graph.constraint_builder.min_score = 0.75;
  return MapLog(SimulateSmallLoop().log, options);
}

TEST(ExplainLoop, TellsTheBestPlaceWhereTheSearchEndedBeforeItFoundThat) {
  int num_better = 0;
  const auto check = [&](const LoopCandidate& pair, const LoopExplanation& explanation) {
    const double best = explanation.best_in_window->score;
    EXPECT_THAT(explanation.checks.back().value,
                HasSubstr(fmt::format("{:.3f} in a window", best)));
    EXPECT_GE(best, pair.score);
    EXPECT_LE(best, pair.score_bound + 1e-6);
    num_better += best > pair.score ? 1 : 0;
  };
  ForSomeBelowMinScore(SmallLoopWithSmallWindows(), check);
  EXPECT_GT(num_better, 0);
}

TEST(ExplainLoop, TellsWhatAWindowMissed) {
  const Recording recording = SmallLoopWithSmallWindows();
  int num_missed = 0;
  int num_better_nowhere = 0;
  const auto check = [&](const LoopCandidate& pair, const LoopExplanation& explanation) {
    const double best = explanation.best_in_window->score;
    const double anywhere =
        SearchWholeSubmap(recording, pair.submap, pair.node, kMinProbability)->score;
    const std::string text = ExplainWholeSubmap(recording, *explanation.best_in_window);
    EXPECT_THAT(text, anywhere > best
                          ? HasSubstr(fmt::format("the best place scores {:.3f}, ", anywhere))
                          : HasSubstr("Nowhere"));
    (anywhere > best ? num_missed : num_better_nowhere) += 1;
  };
  ForSomeBelowMinScore(recording, check);
  EXPECT_GT(num_missed, 0);
  EXPECT_GT(num_better_nowhere, 0);
}

TEST(ExplainLoop, HasNoBestPlaceOfALoopThatWasFound) {
  EXPECT_FALSE(ExplainFirstWith(SmallLoop(), Verdict::kAccepted).best_in_window);
}

/// Maps the small loop, and tells which check failed of the first pair with this verdict.
LoopCheck FailedCheck(const Options& options, Verdict verdict, std::uint64_t seed = 1) {
  const LoopExplanation explanation =
      ExplainFirstWith(MapLog(SimulateSmallLoop(seed).log, options), verdict);
  EXPECT_FALSE(explanation.closed);
  EXPECT_FALSE(explanation.checks.back().passed);
  return explanation.checks.back();
}

TEST(ExplainLoop, NamesTheMissingSupporters) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.consistency.min_num_supporters = 1000;
  EXPECT_EQ(FailedCheck(options, Verdict::kInconsistent).expected, "at least 1000");
}

TEST(ExplainLoop, TellsHowFarALastLookIsFromTheMap) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimization_problem.outliers.max_distance = 0.01;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  int num_refused = 0;
  for (const LoopCandidate& pair : recording.candidates()) {
    if (!pair.last_look || pair.verdict != Verdict::kInconsistent) continue;
    const LoopExplanation explanation = ExplainLoop(recording, pair.submap, pair.node);
    EXPECT_THAT(explanation.answer, HasSubstr("where the optimized map has it"));
    EXPECT_EQ(explanation.checks.back().what, "off the optimized map");
    EXPECT_EQ(explanation.checks.back().expected, "at most 0.01 m, 3.00 deg");
    EXPECT_THAT(explanation.checks.back().value, Not(StartsWith("0.00")));
    ++num_refused;
  }
  EXPECT_GT(num_refused, 0);
}

TEST(ExplainLoop, TellsHowManyReturnsLieOnWallsFromBehind) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.wall_sides.max_share_from_behind = 0.0;
  options.pose_graph.constraint_builder.consistency.min_num_supporters = 0;
  constexpr int kSeedWithSome = 6;
  const LoopCheck check = FailedCheck(options, Verdict::kFromBehind, kSeedWithSome);
  EXPECT_THAT(check.what, HasSubstr("walls"));
  EXPECT_EQ(check.expected, "at most 0 %");
}

TEST(ExplainLoop, TellsThatTheWinnerLiesAtTheBorder) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.ambiguity.refuse_at_border = true;
  options.pose_graph.constraint_builder.ambiguity.max_relative_score = 1.0;
  options.pose_graph.constraint_builder.fast_correlative_scan_matcher.linear_search_window = 0.06;
  options.pose_graph.constraint_builder.linear_search_window_per_meter = 0.0;
  const LoopCheck check = FailedCheck(options, Verdict::kAmbiguous);
  EXPECT_THAT(check.what, HasSubstr("border"));
  EXPECT_EQ(check.value, "yes");
}

TEST(ExplainLoop, TellsWhatAPairThatWasNotSampledWouldHaveScored) {
  const LoopExplanation explanation = ExplainFirstWith(SmallLoop(), Verdict::kNotSampled);
  EXPECT_FALSE(explanation.closed);
  EXPECT_EQ(explanation.checks.back().what, "sampled");
  EXPECT_THAT(explanation.answer, HasSubstr("the best place scores 0."));
  EXPECT_TRUE(explanation.best_in_window);
}

/// As if the user had stopped the mapping after so many scans.
Recording StoppedAfter(const Recording& recording, int num_scans) {
  Recording stopped(recording.log(), recording.options());
  Slam slam(stopped.log(), stopped.options(), 1);
  for (int scan = 0; scan < num_scans; ++scan) stopped.Append(slam.AddScan(scan));
  return stopped;
}

TEST(ExplainLoop, SaysThatTheRecordingEndedTooEarly) {
  const LoopCandidate& loop = FirstWith(SmallLoop(), Verdict::kAccepted);
  ASSERT_LT(loop.considered_step, loop.applied_step);
  const Recording recording = StoppedAfter(SmallLoop(), loop.applied_step);
  const LoopExplanation explanation = ExplainLoop(recording, loop.submap, loop.node);
  EXPECT_FALSE(explanation.closed);
  EXPECT_THAT(explanation.answer, HasSubstr("recording ends"));
  EXPECT_THAT(explanation.answer, HasSubstr("the best place scores 0."));
  EXPECT_TRUE(explanation.best_in_window);
}

/// Of the first pair that the small loop closes, mapped with `options`.
LoopExplanation ExplainClosedPairWith(const Options& options) {
  const LoopCandidate& loop = FirstWith(SmallLoop(), Verdict::kAccepted);
  return ExplainLoop(MapLog(SimulateSmallLoop().log, options), loop.submap, loop.node);
}

TEST(ExplainLoop, SaysThatNoLoopsWereSearched) {
  Options options = SmallLoopOptions();
  options.pose_graph.optimize_every_n_nodes = 0;
  const LoopExplanation explanation = ExplainClosedPairWith(options);
  EXPECT_THAT(explanation.answer, HasSubstr("not searched at all"));
  EXPECT_EQ(explanation.checks.back().what, "optimize_every_n_nodes");
}

TEST(ExplainLoop, SaysThatTheNodeHasNoPoints) {
  Options options = SmallLoopOptions();
  options.trajectory_builder_2d.loop_closure_adaptive_voxel_filter.max_range = 0.1;
  const LoopExplanation explanation = ExplainClosedPairWith(options);
  EXPECT_THAT(explanation.answer, HasSubstr("nothing to match"));
  EXPECT_EQ(explanation.checks.back().value, "0");
}

TEST(ExplainLoop, SaysThatTheSearchWasToCheckALoneLoop) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.sampling_ratio = 0.05;
  options.pose_graph.constraint_builder.second_look.num_nodes = 0;
  options.pose_graph.constraint_builder.last_look.num_nodes = 0;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  int num_checks = 0;
  for (const LoopCandidate& pair : recording.candidates()) {
    if (pair.verdict == Verdict::kNotSampled) continue;
    const Pose2 guess = GuessOfPair(recording, pair.submap, pair.node);
    EXPECT_EQ(guess, ConsiderPair(recording, pair.submap, pair.node).submap_from_node_guess);
    bool says_so = false;
    for (const LoopCheck& check : ExplainLoop(recording, pair.submap, pair.node).checks) {
      says_so = says_so || check.value.find("to check that") != std::string::npos;
    }
    EXPECT_EQ(says_so, guess != pair.submap_from_node_guess);
    num_checks += says_so ? 1 : 0;
  }
  EXPECT_GT(num_checks, 0);
}

TEST(ExplainLoop, SaysThatANodeOfTheSubmapItselfIsNoLoop) {
  const LoopExplanation explanation = ExplainLoop(SmallLoop(), SubmapId{0}, NodeId{3});
  EXPECT_FALSE(explanation.closed);
  EXPECT_THAT(explanation.answer, HasSubstr("INTRA_SUBMAP"));
}

TEST(ExplainLoop, SaysThatASubmapWasNeverFinished) {
  const SubmapId last{static_cast<int>(SmallLoop().submaps().size()) - 1};
  const LoopExplanation explanation = ExplainLoop(SmallLoop(), last, NodeId{0});
  ASSERT_EQ(explanation.checks.size(), 1u);
  EXPECT_FALSE(explanation.checks[0].passed);
  EXPECT_THAT(explanation.answer, HasSubstr("never finished"));
}

TEST(ExplainLoop, TellsHowFarIsTooFar) {
  Options options = SmallLoopOptions();
  options.pose_graph.constraint_builder.max_constraint_distance = 0.5;
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  // The ring is 10 m long: half a round later the robot is on its other side.
  const LoopExplanation explanation =
      ExplainLoop(recording, SubmapId{0}, NodeId{static_cast<int>(recording.nodes().size()) / 3});
  EXPECT_FALSE(explanation.closed);
  EXPECT_THAT(explanation.checks.back().what, HasSubstr("distance"));
  EXPECT_FALSE(explanation.checks.back().passed);
}

}  // namespace
}  // namespace loopscope
