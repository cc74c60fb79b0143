// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/timeline.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/small_loop_run.h"

namespace loopscope {

void PrintTo(const Event& event, std::ostream* out) {
  *out << ToString(event.kind) << " " << event.index << " at step " << event.step;
}

namespace {

using testing::ElementsAre;
using testing::Optional;
using Kind = Event::Kind;

/// A node in a submap of its own.
SlamUpdate NodeUpdate(int step, int node) {
  SlamUpdate update;
  update.step.outcome = StepOutcome::kInserted;
  update.step.node = NodeId{node};
  update.started_submap = Submap{Pose2(), NodeId{node}, 0, -1};
  update.node = Node{step, Pose2(), SubmapId{node}, 1};
  return update;
}

LoopCandidate CandidateWith(Verdict verdict, int applied_step) {
  LoopCandidate candidate;
  candidate.verdict = verdict;
  candidate.applied_step = applied_step;
  return candidate;
}

/// Step 0: a node. Step 1: submap 0 is finished. Step 2: of all verdicts one, and an optimization.
/// Step 3: nothing. Step 4: submap 1 is finished, a loop, and an optimization.
std::vector<SlamUpdate> Updates() {
  std::vector<SlamUpdate> updates = {NodeUpdate(0, 0), NodeUpdate(1, 1), NodeUpdate(2, 2),
                                     SlamUpdate(), NodeUpdate(4, 3)};
  updates[1].finished_submap = SubmapId{0};
  for (const Verdict verdict : {Verdict::kAccepted, Verdict::kNotSampled, Verdict::kInconsistent,
                                Verdict::kBelowMinScore, Verdict::kAmbiguous}) {
    updates[2].candidates.push_back(CandidateWith(verdict, 2));
  }
  updates[2].optimization = Optimization{2, false, {}, {}};
  updates[4].finished_submap = SubmapId{1};
  updates[4].candidates = {CandidateWith(Verdict::kAccepted, 4)};
  updates[4].optimization = Optimization{4, true, {}, {}};
  return updates;
}

Timeline TimelineOfAll() {
  Recording recording(ScanLog{}, Options());
  for (const SlamUpdate& update : Updates()) recording.Append(update);
  Timeline timeline;
  timeline.Append(recording);
  return timeline;
}

TEST(Timeline, HasSubmapsLoopsAndOptimizationsInTheOrderOfSteps) {
  EXPECT_THAT(TimelineOfAll().events(),
              ElementsAre(Event{1, Kind::kSubmapFinished, 0}, Event{2, Kind::kLoopBelowScore, 3},
                          Event{2, Kind::kLoopRefused, 2}, Event{2, Kind::kLoopRefused, 4},
                          Event{2, Kind::kLoopClosed, 0}, Event{2, Kind::kOptimization, 0},
                          Event{4, Kind::kSubmapFinished, 1}, Event{4, Kind::kLoopClosed, 5},
                          Event{4, Kind::kOptimization, 1}));
}

TEST(Timeline, GrownBitByBitEqualsThatOfTheWholeRun) {
  for (const int steps_at_once : {1, 2, 3}) {
    Recording recording(ScanLog{}, Options());
    Timeline timeline;
    for (const SlamUpdate& update : Updates()) {
      recording.Append(update);
      if (recording.num_steps() % steps_at_once == 0) timeline.Append(recording);
    }
    timeline.Append(recording);
    EXPECT_EQ(timeline.events(), TimelineOfAll().events()) << steps_at_once;
  }
}

TEST(Timeline, HasEveryEventOfARealRunOnce) {
  const Recording& run = SmallLoopRun();
  Timeline timeline;
  timeline.Append(run);
  timeline.Append(run);
  std::size_t expected = run.optimizations().size();
  for (const Submap& submap : run.submaps()) expected += submap.finished_step >= 0 ? 1 : 0;
  for (const LoopCandidate& candidate : run.candidates()) {
    expected += candidate.verdict == Verdict::kNotSampled ? 0 : 1;
  }
  EXPECT_EQ(timeline.events().size(), expected);
  EXPECT_TRUE(std::is_sorted(timeline.events().begin(), timeline.events().end(),
                             [](const Event& a, const Event& b) { return a.step < b.step; }));
}

TEST(Timeline, FindsTheNextEventOfTheKindsWanted) {
  const Timeline timeline = TimelineOfAll();
  const std::set<Kind> loops = {Kind::kLoopClosed};
  EXPECT_THAT(timeline.NextEvent(-1, loops), Optional(Event{2, Kind::kLoopClosed, 0}));
  EXPECT_THAT(timeline.NextEvent(1, loops), Optional(Event{2, Kind::kLoopClosed, 0}));
  EXPECT_THAT(timeline.NextEvent(2, loops), Optional(Event{4, Kind::kLoopClosed, 5}));
  EXPECT_EQ(timeline.NextEvent(4, loops), std::nullopt);
  EXPECT_THAT(timeline.NextEvent(1, {Kind::kLoopRefused, Kind::kOptimization}),
              Optional(Event{2, Kind::kLoopRefused, 2}));
  EXPECT_EQ(timeline.NextEvent(-1, {}), std::nullopt);
  EXPECT_EQ(Timeline().NextEvent(-1, loops), std::nullopt);
}

TEST(Timeline, FindsThePreviousEventOfTheKindsWanted) {
  const Timeline timeline = TimelineOfAll();
  const std::set<Kind> submaps = {Kind::kSubmapFinished};
  EXPECT_THAT(timeline.PreviousEvent(9, submaps), Optional(Event{4, Kind::kSubmapFinished, 1}));
  EXPECT_THAT(timeline.PreviousEvent(4, submaps), Optional(Event{1, Kind::kSubmapFinished, 0}));
  EXPECT_EQ(timeline.PreviousEvent(1, submaps), std::nullopt);
  EXPECT_THAT(timeline.PreviousEvent(3, {Kind::kLoopRefused, Kind::kLoopBelowScore}),
              Optional(Event{2, Kind::kLoopRefused, 4}));
}

TEST(Timeline, KindsHaveNames) {
  EXPECT_EQ(ToString(Kind::kSubmapFinished), "submap finished");
  EXPECT_EQ(ToString(Kind::kLoopBelowScore), "loop below score");
  EXPECT_EQ(ToString(Kind::kLoopRefused), "loop refused");
  EXPECT_EQ(ToString(Kind::kLoopClosed), "loop closed");
  EXPECT_EQ(ToString(Kind::kOptimization), "optimization");
}

}  // namespace
}  // namespace loopscope
