// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/inspection_report.h"

#include <stdexcept>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/graph/spa_cost.h"
#include "core/slam/covariance.h"
#include "core/slam/derive.h"
#include "core/slam/loop_explanation.h"
#include "tests/support/small_loop_run.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::vector<std::string> TitlesOf(const InspectionReport& report) {
  std::vector<std::string> titles;
  for (const Section& section : report) titles.push_back(section.title);
  return titles;
}

std::vector<std::string> NamesOf(const Section& section) {
  std::vector<std::string> names;
  for (const ReportRow& row : section.rows) names.push_back(row.name);
  return names;
}

/// The value of the first row of this name; fails if there is none.
std::string ValueOf(const InspectionReport& report, const std::string& name) {
  for (const Section& section : report) {
    for (const ReportRow& row : section.rows) {
      if (row.name == name) return row.value;
    }
  }
  ADD_FAILURE() << "no row " << name;
  return "";
}

const Section& SectionOf(const InspectionReport& report, const std::string& title) {
  for (const Section& section : report) {
    if (section.title == title) return section;
  }
  throw std::out_of_range("no section " + title);
}

std::string MetersAndDegrees(const Eigen::Vector3d& residual) {
  return fmt::format("{:.3f} m, {:.2f} deg", residual.head<2>().norm(),
                     RadiansToDegrees(std::abs(residual.z())));
}

std::string PoseText(const Pose2& pose) {
  return fmt::format("{:.3f} m, {:.3f} m, {:.2f} deg", pose.x(), pose.y(),
                     RadiansToDegrees(pose.rotation));
}

const LoopCandidate& FirstWith(Verdict verdict) {
  return SmallLoopRun().candidates()[FirstCandidateWith(SmallLoopRun(), verdict)];
}

TEST(ReportOnStep, TellsOfTheScanAndItsMatch) {
  const Recording& run = SmallLoopRun();
  const int step = run.nodes()[10].step;
  const MapState state = StateAfterStep(run, step);
  const InspectionReport report = ReportOnStep(run, state);
  const Step& record = run.step(step);
  EXPECT_THAT(TitlesOf(report), Contains("Scan match (local frame)"));
  EXPECT_EQ(ValueOf(report, "outcome"), "became node (0, 10)");
  EXPECT_EQ(ValueOf(report, "time"),
            fmt::format("{:.2f} s", run.log().scans[step].time - run.log().scans[0].time));
  EXPECT_EQ(ValueOf(report, "robot (global frame)"), PoseText(state.global_from_base));
  EXPECT_EQ(ValueOf(report, "predicted"), PoseText(record.local_from_base_prior));
  EXPECT_EQ(ValueOf(report, "correlative matcher"), PoseText(*record.local_from_base_correlative));
  EXPECT_EQ(ValueOf(report, "matched"), PoseText(record.local_from_base));
  EXPECT_EQ(ValueOf(report, "match began"), "where predicted");
  const Pose2 moved = record.local_from_base_prior.Inverse() * record.local_from_base;
  EXPECT_EQ(ValueOf(report, "moved by the match"),
            MetersAndDegrees({moved.x(), moved.y(), moved.rotation}));
  EXPECT_EQ(ValueOf(report, "odometry (odom frame)"),
            PoseText(OdometryOfScan(run.log(), step)->odom_from_base));
  EXPECT_EQ(ValueOf(report, "nodes"), "11");
  EXPECT_EQ(ValueOf(report, "use_odometry"), "true");
}

TEST(ReportOnStep, TellsThatTheFirstScanWasNotMatched) {
  const InspectionReport report = ReportOnStep(SmallLoopRun(), StateAfterStep(SmallLoopRun(), 0));
  EXPECT_EQ(ValueOf(report, "match began"), "nowhere: not matched");
}

TEST(ReportOnStep, TellsWhatTheScanCaused) {
  const Recording& run = SmallLoopRun();
  const int step = FirstWith(Verdict::kAccepted).applied_step;
  const InspectionReport report = ReportOnStep(run, StateAfterStep(run, step));
  const auto num_closed =
      std::count_if(run.candidates().begin(), run.candidates().end(), [&](const auto& candidate) {
        return candidate.applied_step == step && candidate.verdict == Verdict::kAccepted;
      });
  const Section& caused = SectionOf(report, "Caused");
  EXPECT_EQ(ValueOf({caused}, "loops closed"), std::to_string(num_closed));
  EXPECT_THAT(ValueOf({caused}, "optimization"), HasSubstr("iterations"));
  EXPECT_THAT(NamesOf(caused), Not(Contains("final optimization")));
  EXPECT_THAT(NamesOf(SectionOf(ReportOnStep(run, LastState(run)), "Caused")),
              Contains("final optimization"));
}

TEST(ReportOnStep, CountsTheLoopsUntilTheStep) {
  const Recording& run = SmallLoopRun();
  const LoopCandidate& first = FirstWith(Verdict::kAccepted);
  for (const int step : {first.applied_step - 1, first.applied_step, run.num_steps() - 1}) {
    const auto num_closed =
        std::count_if(run.candidates().begin(), run.candidates().end(), [&](const auto& candidate) {
          return candidate.applied_step <= step && candidate.verdict == Verdict::kAccepted;
        });
    EXPECT_EQ(ValueOf({SectionOf(ReportOnStep(run, StateAfterStep(run, step)), "So far")},
                      "loops closed"),
              std::to_string(num_closed));
  }
}

TEST(ReportOnStep, NamesTheSubmapsBegunAndFinished) {
  const Recording& run = SmallLoopRun();
  const int step = run.submaps()[0].finished_step;
  const Section caused = SectionOf(ReportOnStep(run, StateAfterStep(run, step)), "Caused");
  EXPECT_EQ(ValueOf({caused}, "submap finished"), "(0, 0)");
  const int begun = run.node(run.submaps()[2].first_node).step;
  EXPECT_EQ(
      ValueOf({SectionOf(ReportOnStep(run, StateAfterStep(run, begun)), "Caused")}, "submap begun"),
      "(0, 2)");
}

TEST(ReportOnStep, LeavesOutWhatAQuietScanDidNotCause) {
  const Recording& run = SmallLoopRun();
  const InspectionReport report = ReportOnStep(run, StateAfterStep(run, run.nodes()[1].step));
  EXPECT_THAT(TitlesOf(report), Not(Contains("Caused")));
}

TEST(ReportOnNode, HasItsPosesInEveryFrame) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const NodeId node{20};
  const Node& record = run.node(node);
  ASSERT_EQ(record.num_submaps, 2);
  const SubmapId second{record.first_submap.index + 1};
  const InspectionReport report = ReportOnNode(run, state, node);
  EXPECT_EQ(report[0].title, "Node (0, 20)");
  EXPECT_EQ(ValueOf(report, "step"), std::to_string(record.step));
  EXPECT_EQ(ValueOf(report, "inserted into"),
            ToString(record.first_submap) + " and " + ToString(second));
  EXPECT_EQ(ValueOf(report, "global frame"), PoseText(state.global_from_node[20]));
  EXPECT_EQ(ValueOf(report, "local frame"), PoseText(record.local_from_base));
  EXPECT_EQ(ValueOf(report, "in submap " + ToString(second)),
            PoseText(SubmapFromNode(run, second, node)));
}

TEST(ReportOnNode, HasTheResidualOfEveryConstraint) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const LoopCandidate& loop = FirstWith(Verdict::kAccepted);
  const InspectionReport report = ReportOnNode(run, state, loop.node);
  EXPECT_EQ(ValueOf(report, "INTER, submap " + ToString(loop.submap)),
            MetersAndDegrees(LoopResidual(state, loop)));
  const SubmapId first = run.node(loop.node).first_submap;
  EXPECT_EQ(ValueOf(report, "INTRA, submap " + ToString(first)),
            MetersAndDegrees(SpaError(SubmapFromNode(run, first, loop.node),
                                      state.global_from_submap[first.index],
                                      state.global_from_node[loop.node.index])));
  const auto num_skipped =
      std::count_if(run.candidates().begin(), run.candidates().end(), [&](const auto& candidate) {
        return candidate.node == loop.node && candidate.verdict == Verdict::kNotSampled;
      });
  EXPECT_EQ(ValueOf(report, "not sampled"), std::to_string(num_skipped));
  const std::vector<std::string> names = NamesOf(SectionOf(report, "Residuals of its constraints"));
  const auto num_inter = std::count_if(
      names.begin(), names.end(), [](const std::string& name) { return name.find("INTER") == 0; });
  EXPECT_EQ(ValueOf(report, "closed"), std::to_string(num_inter));
}

TEST(ReportOnNode, SaysThatANodeOfLaterHasNoGlobalPoseYet) {
  const Recording& run = SmallLoopRun();
  const InspectionReport report = ReportOnNode(run, StateAfterStep(run, 0), NodeId{20});
  EXPECT_EQ(ValueOf(report, "global frame"),
            fmt::format("none before step {}", run.nodes()[20].step));
  EXPECT_THAT(TitlesOf(report), Not(Contains("Residuals of its constraints")));
}

TEST(ReportOnSubmap, HasNodesPosesAndLoops) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const SubmapId id = FirstWith(Verdict::kAccepted).submap;
  const Submap& submap = run.submap(id);
  double largest = 0.0;
  int num_loops = 0;
  for (const LoopCandidate& candidate : run.candidates()) {
    if (candidate.submap != id || candidate.verdict != Verdict::kAccepted) continue;
    ++num_loops;
    largest = std::max(largest, LoopResidual(state, candidate).head<2>().norm());
  }
  const InspectionReport report = ReportOnSubmap(run, state, id);
  EXPECT_EQ(report[0].title, "Submap " + ToString(id));
  EXPECT_EQ(ValueOf(report, "finished at step"), std::to_string(submap.finished_step));
  EXPECT_EQ(ValueOf(report, "nodes"),
            fmt::format("{}, from {} on", submap.num_nodes, ToString(submap.first_node)));
  EXPECT_EQ(ValueOf(report, "global frame"), PoseText(state.global_from_submap[id.index]));
  EXPECT_EQ(ValueOf(report, "local frame"), PoseText(submap.local_from_submap));
  EXPECT_EQ(ValueOf(report, "closed"), std::to_string(num_loops));
  EXPECT_THAT(ValueOf(report, "largest residual"),
              StartsWith(fmt::format("{:.3f} m, node (0, ", largest)));
  EXPECT_EQ(ValueOf(report, "TRAJECTORY_BUILDER_2D.submaps.num_range_data"), "8");
}

TEST(ReportOnSubmap, ShowsASubmapAsItWasAtTheStep) {
  const Recording& run = SmallLoopRun();
  const MapState state = StateAfterStep(run, run.submaps()[0].finished_step - 1);
  EXPECT_EQ(ValueOf(ReportOnSubmap(run, state, SubmapId{0}), "finished at step"), "not yet");
  const InspectionReport later = ReportOnSubmap(run, state, SubmapId{5});
  EXPECT_EQ(ValueOf(later, "nodes"), "none yet");
  EXPECT_THAT(ValueOf(later, "global frame"), StartsWith("none before step "));
  EXPECT_THAT(NamesOf(SectionOf(later, "Loop candidates")), Not(Contains("mean residual")));
}

TEST(ReportOnPair, HasTheGatesOfTheExplanationWithValueAndThreshold) {
  const Recording& run = SmallLoopRun();
  for (const Verdict verdict : {Verdict::kAccepted, Verdict::kNotSampled}) {
    const LoopCandidate& candidate = FirstWith(verdict);
    const LoopExplanation explanation = ExplainLoop(run, candidate.submap, candidate.node);
    const InspectionReport report =
        ReportOnPair(run, LastState(run), candidate.submap, candidate.node);
    const std::vector<ReportRow>& gates = SectionOf(report, "Gates").rows;
    ASSERT_EQ(gates.size(), explanation.checks.size() + 1);
    for (std::size_t i = 0; i < explanation.checks.size(); ++i) {
      EXPECT_EQ(gates[i].name, explanation.checks[i].what);
      EXPECT_EQ(gates[i].value, explanation.checks[i].value);
      EXPECT_EQ(gates[i].expected, explanation.checks[i].expected);
      EXPECT_EQ(gates[i].passed, explanation.checks[i].passed);
    }
    EXPECT_EQ(gates.back().value, explanation.answer);
  }
}

TEST(ReportOnPair, HasTheResidualsOfALoopBeforeAndAfterAndAtTheStepShown) {
  const Recording& run = SmallLoopRun();
  const LoopCandidate& loop = FirstWith(Verdict::kAccepted);
  const MapState state = LastState(run);
  const InspectionReport report = ReportOnPair(run, state, loop.submap, loop.node);
  EXPECT_EQ(ValueOf(report, "candidate"),
            std::to_string(FirstCandidateWith(run, Verdict::kAccepted)));
  EXPECT_EQ(ValueOf(report, "verdict"), "closed");
  EXPECT_EQ(ValueOf(report, "refined"), PoseText(loop.submap_from_node));
  EXPECT_EQ(ValueOf(report, "before its first optimization"),
            MetersAndDegrees(LoopResidual(StateBeforeOptimization(run, loop.applied_step), loop)));
  EXPECT_EQ(ValueOf(report, "after it"),
            MetersAndDegrees(LoopResidual(StateAfterStep(run, loop.applied_step), loop)));
  EXPECT_EQ(ValueOf(report, fmt::format("at step {}", state.step)),
            MetersAndDegrees(LoopResidual(state, loop)));
  EXPECT_EQ(ValueOf(report, "POSE_GRAPH.constraint_builder.max_constraint_distance"), "5 m");
  EXPECT_EQ(ValueOf(ReportOnPair(run, StateAfterStep(run, 0), loop.submap, loop.node), "at step 0"),
            "not yet in the graph");
}

TEST(ReportOnPair, TellsOfNoSearchWhereThereWasNone) {
  const Recording& run = SmallLoopRun();
  const LoopCandidate& skipped = FirstWith(Verdict::kNotSampled);
  EXPECT_THAT(TitlesOf(ReportOnPair(run, LastState(run), skipped.submap, skipped.node)),
              ElementsAre(HasSubstr("Node "), "Gates", "Options in force"));
  const InspectionReport never = ReportOnPair(run, LastState(run), SubmapId{0}, NodeId{0});
  EXPECT_EQ(ValueOf(never, "verdict"), "none: the pair never was a candidate");
}

TEST(ReportOnMatch, HasTheScoresBeforeAndAfterTheMatch) {
  const Recording& run = SmallLoopRun();
  const int step = run.nodes()[30].step;
  const auto replay = ReplayMatch(run, step);
  const InspectionReport report = {ReportOnMatch(run, step)};
  EXPECT_EQ(ValueOf(report, "matched against"), "submap " + ToString(replay->submap));
  EXPECT_EQ(ValueOf(report, "score where predicted"), fmt::format("{:.3f}", replay->prior_score));
  EXPECT_EQ(ValueOf(report, "score where matched"), fmt::format("{:.3f}", replay->score));
  EXPECT_THAT(ValueOf({ReportOnMatch(run, 0)}, "matched against"), StartsWith("nothing"));
}

TEST(ReportOnCovariance, HasTheDeviationsOfTheGraph) {
  const Recording& run = SmallLoopRun();
  const MapState state = StateAfterStep(run, run.nodes()[40].step);
  const Eigen::Matrix3d covariance = *CovarianceOfNode(run, state, NodeId{40});
  const InspectionReport node = {ReportOnCovariance(run, state, NodeId{40})};
  EXPECT_EQ(ValueOf(node, "standard deviation of x"),
            fmt::format("{:.4f} m", std::sqrt(covariance(0, 0))));
  EXPECT_EQ(ValueOf(node, "standard deviation of y"),
            fmt::format("{:.4f} m", std::sqrt(covariance(1, 1))));
  EXPECT_EQ(ValueOf(node, "standard deviation of heading"),
            fmt::format("{:.4f} deg", RadiansToDegrees(std::sqrt(covariance(2, 2)))));
  EXPECT_EQ(
      ValueOf(node, "correlation of x and y"),
      fmt::format("{:.2f}", covariance(0, 1) / std::sqrt(covariance(0, 0) * covariance(1, 1))));
  const Section first = ReportOnCovariance(run, state, SubmapId{0});
  EXPECT_EQ(ValueOf({first}, "standard deviation of x"), "0.0000 m");
  EXPECT_THAT(NamesOf(first), Not(Contains("correlation of x and y")));
}

TEST(InspectionReport, RefusesWhatTheRecordingDoesNotHave) {
  const Recording& run = SmallLoopRun();
  const MapState state = LastState(run);
  const MapState early = StateAfterStep(run, 0);
  const std::string last_node = std::to_string(run.nodes().size() - 1);
  const std::string last_submap = std::to_string(run.submaps().size() - 1);
  EXPECT_EQ(MessageOf([&] { ReportOnNode(run, state, NodeId{9999}); }),
            "no node 9999: expected 0 to " + last_node);
  EXPECT_EQ(MessageOf([&] { ReportOnSubmap(run, state, SubmapId{-1}); }),
            "no submap -1: expected 0 to " + last_submap);
  EXPECT_THROW(ReportOnPair(run, state, SubmapId{9999}, NodeId{0}), std::invalid_argument);
  EXPECT_THROW(ReportOnPair(run, state, SubmapId{0}, NodeId{-1}), std::invalid_argument);
  EXPECT_EQ(MessageOf([&] { ReportOnCovariance(run, early, NodeId{20}); }),
            "there is no node (0, 20) at step 0; expected one that has a pose");
  EXPECT_THROW(ReportOnCovariance(run, early, SubmapId{3}), std::invalid_argument);
}

}  // namespace
}  // namespace loopscope
