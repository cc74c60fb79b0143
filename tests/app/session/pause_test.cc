// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/pause.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using testing::Optional;
using Kind = Event::Kind;

LoopCandidate CandidateWith(Verdict verdict, int applied_step, double x = 0.0) {
  LoopCandidate candidate;
  candidate.verdict = verdict;
  candidate.applied_step = applied_step;
  candidate.submap_from_node = Pose2(x, 0.0, 0.0);
  return candidate;
}

/// Submap 0 and node 0 are at the same place. Step 1: loops that say that they are 0.3 m, 0.5 m and
/// 0.4 m apart, and an optimization that believes 0.5 m. Step 2: nothing. Step 3: a loop that is
/// ambiguous and one below the score. Step 4: an inconsistent one.
Recording SmallRecording() {
  Recording recording(ScanLog{}, Options());
  std::vector<SlamUpdate> updates(5);
  updates[0].started_submap = Submap();
  updates[0].node = Node{0, Pose2(), SubmapId{0}, 1};
  updates[1].candidates = {
      CandidateWith(Verdict::kInconsistent, 1, 9.0), CandidateWith(Verdict::kAccepted, 1, 0.3),
      CandidateWith(Verdict::kAccepted, 1, 0.5), CandidateWith(Verdict::kAccepted, 1, 0.4)};
  updates[1].optimization = Optimization{1, false, {Pose2()}, {Pose2(0.5, 0.0, 0.0)}};
  updates[3].candidates = {CandidateWith(Verdict::kBelowMinScore, 3),
                           CandidateWith(Verdict::kAmbiguous, 3)};
  updates[4].candidates = {CandidateWith(Verdict::kInconsistent, 4)};
  for (const SlamUpdate& update : updates) recording.Append(update);
  return recording;
}

PauseConditions OnLoop() { return {true, false, std::nullopt}; }
PauseConditions OnRejection() { return {false, true, std::nullopt}; }
PauseConditions OnResidualAbove(double meters) { return {false, false, meters}; }

TEST(ShouldPause, GoesOnIfNothingIsAskedFor) {
  for (int step = 0; step < 5; ++step) {
    EXPECT_EQ(ShouldPause(SmallRecording(), step, {}), std::nullopt) << step;
  }
}

TEST(ShouldPause, PausesAtTheFirstLoopClosedAtTheStep) {
  EXPECT_EQ(ShouldPause(SmallRecording(), 0, OnLoop()), std::nullopt);
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, OnLoop()), Optional(Event{1, Kind::kLoopClosed, 1}));
  for (int step = 2; step < 5; ++step) {
    EXPECT_EQ(ShouldPause(SmallRecording(), step, OnLoop()), std::nullopt) << step;
  }
}

TEST(ShouldPause, PausesAtLoopsRefusedButNotAtThoseBelowTheScore) {
  EXPECT_THAT(ShouldPause(SmallRecording(), 3, OnRejection()),
              Optional(Event{3, Kind::kLoopRefused, 5}));
  EXPECT_THAT(ShouldPause(SmallRecording(), 4, OnRejection()),
              Optional(Event{4, Kind::kLoopRefused, 6}));
  EXPECT_EQ(ShouldPause(SmallRecording(), 2, OnRejection()), std::nullopt);
}

TEST(ShouldPause, PausesAtTheLoopThatWasFarthestOffBeforeTheOptimization) {
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, OnResidualAbove(0.45)),
              Optional(Event{1, Kind::kLoopClosed, 2}));
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, OnResidualAbove(0.1)),
              Optional(Event{1, Kind::kLoopClosed, 2}));
  EXPECT_EQ(ShouldPause(SmallRecording(), 1, OnResidualAbove(0.55)), std::nullopt);
  EXPECT_EQ(ShouldPause(SmallRecording(), 3, OnResidualAbove(0.0)), std::nullopt);
}

TEST(ShouldPause, ALoopFarOffComesBeforeOthers) {
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, {true, true, 0.45}),
              Optional(Event{1, Kind::kLoopClosed, 2}));
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, {true, true, 0.55}),
              Optional(Event{1, Kind::kLoopClosed, 1}));
  EXPECT_THAT(ShouldPause(SmallRecording(), 1, {false, true, 0.55}),
              Optional(Event{1, Kind::kLoopRefused, 0}));
}

}  // namespace
}  // namespace loopscope
