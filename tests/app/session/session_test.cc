// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/session.h"

#include <gtest/gtest.h>

#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

Session Loaded() {
  Session session;
  session.Load("small.loopscope", SmallLoopRun());
  return session;
}

SessionState AtStep(const Session& session, int step) {
  SessionState state = session.state();
  state.step = step;
  return state;
}

/// What scan `step` of the small loop caused, as a mapper tells it.
std::vector<SlamUpdate> UpdatesOfSmallLoop(int count) {
  static const ScanLog log = SimulateSmallLoop().log;
  Slam slam(log, SmallLoopOptions(), 1);
  std::vector<SlamUpdate> updates;
  for (int scan = 0; scan < count; ++scan) updates.push_back(slam.AddScan(scan));
  return updates;
}

TEST(SessionTest, LooksAtTheLastStepOfWhatItLoads) {
  const Session session = Loaded();
  EXPECT_EQ(session.state().step, SmallLoopRun().num_steps() - 1);
  EXPECT_EQ(session.path(), "small.loopscope");
  EXPECT_FALSE(session.timeline().events().empty());
}

TEST(SessionTest, UndoesAndRedoesWhatWasDone) {
  Session session = Loaded();
  const SessionState before = session.state();
  session.Change("step", AtStep(session, 10));
  const SessionState after = session.state();
  session.Undo();
  EXPECT_EQ(session.state(), before);
  session.Redo();
  EXPECT_EQ(session.state(), after);
  EXPECT_FALSE(session.can_redo());
}

TEST(SessionTest, UndoesManyStepsAtOnceButNotWhatCameBetweenThem) {
  Session session = Loaded();
  const SessionState before = session.state();
  for (const int step : {10, 11, 12}) session.Change("step", AtStep(session, step));
  SessionState selected = session.state();
  selected.node = NodeId{3};
  session.Change("select.node", selected);
  session.Change("step", AtStep(session, 13));
  session.Undo();
  EXPECT_EQ(session.state().step, 12);
  session.Undo();
  EXPECT_FALSE(session.state().node);
  session.Undo();
  EXPECT_EQ(session.state(), before);
  EXPECT_FALSE(session.can_undo());
}

TEST(SessionTest, ForgetsHowASearchOfAnotherRecordingWasFiltered) {
  Session session = Loaded();
  SessionState state = session.state();
  state.search.num_visits = 7;
  session.Change("visits", state);
  session.Load("other.loopscope", SmallLoopRun());
  EXPECT_TRUE(session.state().search.empty());
}

TEST(SessionTest, FollowsARecordingThatGrowsUnlessAnEarlierStepIsLookedAt) {
  const std::vector<SlamUpdate> updates = UpdatesOfSmallLoop(8);
  Session session;
  session.Load("", Recording(SimulateSmallLoop().log, SmallLoopOptions()));
  EXPECT_FALSE(session.has_steps());
  for (int i = 0; i < 4; ++i) session.Append(updates[i]);
  EXPECT_EQ(session.state().step, 3);
  session.Change("step", AtStep(session, 1));
  for (int i = 4; i < 8; ++i) session.Append(updates[i]);
  EXPECT_EQ(session.state().step, 1);
  EXPECT_EQ(session.last_step(), 7);
}

TEST(SessionTest, PlaysAsManyScansAsTheTimeIsWorthAndStopsAtTheEnd) {
  Session session = Loaded();
  session.Change("step", AtStep(session, 0));
  session.SetSpeed(10.0);
  session.Play(true);
  session.Advance(0.25);
  EXPECT_EQ(session.state().step, 2);
  session.Advance(0.05);
  EXPECT_EQ(session.state().step, 3) << "half a scan was left of the time before";
  session.Advance(1e4);
  EXPECT_EQ(session.state().step, session.last_step());
  EXPECT_FALSE(session.playing());
}

TEST(SessionTest, PausesAtTheEventThatItIsToPauseAt) {
  Session session = Loaded();
  session.Change("step", AtStep(session, 0));
  PauseConditions conditions;
  conditions.on_loop = true;
  session.SetPauseConditions(conditions);
  session.SetSpeed(1000.0);
  session.Play(true);
  session.Advance(1e3);
  const auto loop = session.timeline().NextEvent(0, {Event::Kind::kLoopClosed});
  ASSERT_TRUE(loop);
  EXPECT_EQ(session.state().step, loop->step);
  EXPECT_FALSE(session.playing());
}

TEST(SessionTest, AsksForTheSelectedPairInASearchAndForTheStepElsewhere) {
  Session session = Loaded();
  SessionState state = AtStep(session, 150);
  state.tiles = {ViewKind::kSearch, ViewKind::kUpdate};
  state.node = NodeId{40};
  state.submap = SubmapId{0};
  session.Change("", state);
  const ViewRequest search = session.RequestOf(0);
  EXPECT_EQ(search.node, NodeId{40});
  EXPECT_EQ(search.submap, SubmapId{0});
  const ViewRequest update = session.RequestOf(1);
  EXPECT_EQ(update.step, 150);
  EXPECT_FALSE(update.node);
  EXPECT_FALSE(update.submap) << "the scan of step 150 did not go into submap 0";
}

TEST(SessionTest, AsksForTheSelectionAndTheMarkedLoopsInAllViewsOfTheRun) {
  Session session = Loaded();
  const int loop = FirstCandidateWith(SmallLoopRun(), Verdict::kAccepted);
  SessionState state = session.state();
  state.tiles = {ViewKind::kTime, ViewKind::kChart, ViewKind::kMap, ViewKind::kMatch};
  state.node = NodeId{40};
  state.submap = SubmapId{0};
  state.loops = {loop};
  state.chart = ChartKind::kResiduals;
  session.Change("", state);
  for (int tile = 0; tile < 3; ++tile) {
    const ViewRequest request = session.RequestOf(tile);
    EXPECT_EQ(request.node, NodeId{40});
    EXPECT_EQ(request.submap, SubmapId{0});
    ASSERT_EQ(request.marked.size(), 1u);
    EXPECT_EQ(request.marked[0].node, SmallLoopRun().candidates()[loop].node);
  }
  EXPECT_EQ(session.RequestOf(0).chart, ChartKind::kScores) << "only a chart has a kind of chart";
  EXPECT_EQ(session.RequestOf(1).chart, ChartKind::kResiduals);
  EXPECT_TRUE(session.RequestOf(3).marked.empty());
}

TEST(SessionTest, MarksNoLoopsBesideAnotherPair) {
  Session session = Loaded();
  SessionState state = session.state();
  state.node = NodeId{40};
  state.loops = {3};
  session.Change("", state);
  EXPECT_EQ(session.state().loops, std::vector<int>{3});
  state.node = NodeId{41};
  session.Change("", state);
  EXPECT_TRUE(session.state().loops.empty());
}

TEST(SessionTest, AsksForDarkPicturesInADarkWindowWhateverIsUndone) {
  Session session = Loaded();
  session.SetDark(true);
  EXPECT_EQ(session.RequestOf(0).theme, Theme::kDark);
  SessionState state = session.state();
  state.theme = Theme::kColorBlind;
  session.Change("", state);
  EXPECT_EQ(session.RequestOf(0).theme, Theme::kDarkColorBlind);
  session.Undo();
  EXPECT_EQ(session.RequestOf(0).theme, Theme::kDark);
  session.SetDark(false);
  EXPECT_EQ(session.RequestOf(0).theme, Theme::kDefault);
}

TEST(SessionTest, HasTheMapOfTheStepThatIsLookedAt) {
  Session session = Loaded();
  for (const int step : {10, 60}) {
    session.Change("step", AtStep(session, step));
    EXPECT_EQ(session.map().step, step);
    EXPECT_EQ(session.map().num_nodes, StateAfterStep(SmallLoopRun(), step).num_nodes);
  }
}

TEST(SessionTest, DoesNotAskForWhatHadNotBegunAtTheStep) {
  Session session = Loaded();
  SessionState state = AtStep(session, 0);
  state.tiles = {ViewKind::kMap, ViewKind::kSubmap};
  state.submap = SubmapId{3};
  state.node = NodeId{30};
  session.Change("", state);
  EXPECT_FALSE(session.RequestOf(0).node);
  EXPECT_FALSE(session.RequestOf(0).submap);
  EXPECT_FALSE(session.RequestOf(1).submap);
}

TEST(SessionTest, KnowsTheCandidateOfTheSelectedPair) {
  Session session = Loaded();
  EXPECT_FALSE(session.SelectedCandidate());
  const int index = FirstCandidateWith(SmallLoopRun(), Verdict::kAccepted);
  const LoopCandidate& candidate = SmallLoopRun().candidates()[index];
  SessionState state = session.state();
  state.node = candidate.node;
  state.submap = candidate.submap;
  session.Change("", state);
  EXPECT_EQ(session.SelectedCandidate(), index);
}

}  // namespace
}  // namespace loopscope
