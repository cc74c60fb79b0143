// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QTableView>
#include <QtTest>

#include "app/studio/timeline_widget.h"
#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

using SteppingTest = WindowFixture;

TEST_F(SteppingTest, StepsAndEventsAreUndoneAndRedone) {
  OpenSmallLoop();
  const int last = state().step;
  Play({"step.seek 20", "step.next"});
  EXPECT_EQ(state().step, 21);
  Play({"select.node 3", "event.next"});
  EXPECT_GT(state().step, 21);
  Play({"edit.undo"});
  EXPECT_EQ(state().step, 21);
  EXPECT_EQ(state().node, NodeId{3});
  Play({"edit.undo", "edit.undo"});
  EXPECT_EQ(state().step, last);
  EXPECT_FALSE(session().can_undo());
  Play({"edit.redo"});
  EXPECT_EQ(state().step, 21);
}

TEST_F(SteppingTest, EveryStepShowsItsOwnPicture) {
  OpenSmallLoop();
  const Picture last = ViewPicture();
  Play({"step.seek 60"});
  ExpectWindow("map_at_step_60");
  Play({"step.last"});
  ExpectSame(ViewPicture(), last, "last_step_again");
}

TEST_F(SteppingTest, KeysStep) {
  OpenSmallLoop();
  const auto press = [&](int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
    QTest::keyClick(&window(), Qt::Key(key), modifiers);
    return state().step;
  };
  const int last = session().last_step();
  EXPECT_EQ(press(Qt::Key_Left), last - 1);
  EXPECT_EQ(press(Qt::Key_Right), last);
  EXPECT_EQ(press(Qt::Key_Home), 0);
  const int event = press(Qt::Key_Right, Qt::ControlModifier);
  EXPECT_EQ(event, session().timeline().events().front().step);
  EXPECT_EQ(press(Qt::Key_End), last);
  EXPECT_EQ(press(Qt::Key_Left, Qt::ControlModifier),
            session()
                .timeline()
                .PreviousEvent(last, {Event::Kind::kSubmapFinished, Event::Kind::kLoopClosed,
                                      Event::Kind::kLoopRefused, Event::Kind::kOptimization})
                ->step);
  EXPECT_EQ(press(Qt::Key_Z, Qt::ControlModifier), last);
}

TEST_F(SteppingTest, KeysStepWhereverTheFocusIs) {
  OpenSmallLoop();
  for (QWidget* const focus :
       {static_cast<QWidget*>(View()), static_cast<QWidget*>(Find<QTableView>(Raise("Loops")))}) {
    focus->setFocus();
    Play({"step.seek 50"});
    QTest::keyClick(focus, Qt::Key_Right);
    EXPECT_EQ(state().step, 51);
    QTest::keyClick(focus, Qt::Key_Home);
    EXPECT_EQ(state().step, 0);
  }
}

TEST_F(SteppingTest, SpacePlaysAndPauses) {
  OpenSmallLoop();
  Play({"play.speed 50", "step.first"});
  QTest::keyClick(&window(), Qt::Key_Space);
  EXPECT_TRUE(session().playing());
  WaitFor([&] { return state().step >= 5; }, "it plays");
  QTest::keyClick(&window(), Qt::Key_Space);
  EXPECT_FALSE(session().playing());
  const int step = state().step;
  WaitUntilIdle();
  EXPECT_EQ(state().step, step);
}

TEST_F(SteppingTest, PlayingEndsWithTheRunOrPausesOnALoop) {
  OpenSmallLoop();
  Play({"play.speed 1000", "step.first", "pause.on_loop"});
  window().Run("play.toggle");
  WaitFor([&] { return !session().playing(); }, "it pauses");
  const auto loop = session().timeline().NextEvent(0, {Event::Kind::kLoopClosed});
  EXPECT_EQ(state().step, loop->step);
  Play({"pause.on_loop"});
  window().Run("play.toggle");
  WaitFor([&] { return !session().playing(); }, "it ends");
  EXPECT_EQ(state().step, session().last_step());
}

TEST_F(SteppingTest, AClickInTheTimelineGoesThere) {
  OpenSmallLoop();
  auto* const timeline = Find<TimelineWidget>(&window());
  const int y = timeline->height() / 2;
  QTest::mouseClick(timeline, Qt::LeftButton, {}, {timeline->width() / 2, y});
  EXPECT_NEAR(state().step, 0.45 * session().last_step(), 0.08 * session().last_step());
  QTest::mouseClick(timeline, Qt::LeftButton, {}, {timeline->width() - 2, y});
  EXPECT_EQ(state().step, session().last_step());
  QTest::mouseClick(timeline, Qt::LeftButton, {}, {2, y});
  EXPECT_EQ(state().step, 0);
}

}  // namespace
}  // namespace loopscope
