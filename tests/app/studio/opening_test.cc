// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QDropEvent>
#include <QLabel>
#include <QMimeData>
#include <QPushButton>
#include <QtTest>
#include <set>

#include "core/io/recording_file.h"
#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

using OpeningTest = WindowFixture;

TEST_F(OpeningTest, AWindowWithoutRunSaysWhatToDo) {
  EXPECT_FALSE(session().has_recording());
  ExpectWindow("start");
}

TEST_F(OpeningTest, ARecordingIsShownFromItsLastStep) {
  OpenSmallLoop();
  EXPECT_EQ(session().path(), SmallLoopRecording());
  EXPECT_EQ(state().step, ReadRecording(SmallLoopRecording()).num_steps() - 1);
  EXPECT_THAT(window().windowTitle().toStdString(), testing::HasSubstr(SmallLoopRecording()));
  ExpectWindow("map");
}

TEST_F(OpeningTest, ALogIsMappedToItsEndWhileTheSessionFollows) {
  std::set<int> steps_seen;
  window().Run("file.open " + CopyOfLongLog());
  WaitFor(
      [&] {
        steps_seen.insert(session().last_step());
        EXPECT_EQ(state().step, std::max(0, session().last_step()));
        return window().IsIdle();
      },
      "the log is mapped");
  EXPECT_GT(steps_seen.size(), 3u);
  EXPECT_EQ(window().message(), "");
  EXPECT_EQ(session().path(), folder().Path("office.loopscope"));
  const int num_scans = static_cast<int>(session().recording().log().scans.size());
  EXPECT_EQ(session().last_step(), num_scans - 1);
  EXPECT_EQ(ReadRecording(session().path()).num_steps(), num_scans);
  EXPECT_TRUE(View()->has_scene());
}

TEST_F(OpeningTest, AStepThatIsLookedAtStaysWhileTheMapGrows) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 5; }, "some scans are mapped");
  window().Run("step.seek 5");
  WaitUntilIdle();
  EXPECT_EQ(state().step, 5);
  EXPECT_GT(session().last_step(), 5);
}

TEST_F(OpeningTest, WhatWasMappedStaysWhenMappingIsStopped) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 5; }, "some scans are mapped");
  Play({"file.stop_mapping"});
  EXPECT_EQ(ReadRecording(session().path()).num_steps(), session().last_step() + 1);
  EXPECT_LT(session().last_step() + 1, static_cast<int>(session().recording().log().scans.size()));
  Play({"step.first"});
  EXPECT_EQ(state().step, 0);
}

TEST_F(OpeningTest, AFileWhoseReadingIsStoppedIsNotOpened) {
  window().Run("file.open " + SmallLoopRecording());
  window().Run("file.stop_mapping");
  QTest::qWait(1000);
  EXPECT_FALSE(session().has_recording());
  OpenSmallLoop();
  EXPECT_TRUE(session().has_recording());
}

TEST_F(OpeningTest, AnotherFileReplacesTheOneThatIsMapped) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 5; }, "some scans are mapped");
  OpenSmallLoop();
  EXPECT_EQ(session().path(), SmallLoopRecording());
  EXPECT_EQ(session().last_step(), ReadRecording(SmallLoopRecording()).num_steps() - 1);
}

TEST_F(OpeningTest, TheRecordingThatIsMappedIsNotReadMeanwhile) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 5; }, "some scans are mapped");
  window().Run("file.open " + session().path());
  EXPECT_THAT(window().message(), testing::HasSubstr("is being mapped"));
  WaitUntilIdle();
  EXPECT_EQ(session().last_step() + 1, static_cast<int>(session().recording().log().scans.size()));
}

TEST_F(OpeningTest, TheFileAskedForLastIsTheOneThatIsOpened) {
  window().Run("file.open " + CopyOfLog());
  OpenSmallLoop();
  EXPECT_EQ(session().path(), SmallLoopRecording());
}

TEST_F(OpeningTest, ClosingTheWindowEndsMappingAndKeepsWhatWasMapped) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 5; }, "some scans are mapped");
  CloseWindow();
  const Recording recording = ReadRecording(folder().Path("office.loopscope"));
  EXPECT_GT(recording.num_steps(), 5);
  EXPECT_LT(recording.num_steps(), static_cast<int>(recording.log().scans.size()));
}

TEST_F(OpeningTest, AWindowCanBeDestroyedWhileItIsShown) {
  OpenSmallLoop();
  DestroyWindow();
  OpenWindowAnew();
  EXPECT_FALSE(session().has_recording());
}

TEST_F(OpeningTest, AFileDroppedOnTheWindowIsOpened) {
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(QString::fromStdString(SmallLoopRecording()))});
  QDragEnterEvent enter({100, 100}, Qt::CopyAction, &files, Qt::LeftButton, {});
  QApplication::sendEvent(&window(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop({100, 100}, Qt::CopyAction, &files, Qt::LeftButton, {});
  QApplication::sendEvent(&window(), &drop);
  WaitUntilIdle();
  EXPECT_EQ(session().path(), SmallLoopRecording());
}

TEST_F(OpeningTest, AnotherRecordingIsShownWithoutWhatWasSelectedInTheOneBefore) {
  OpenSmallLoop();
  Play({"select.pair 20 0"});
  OpenSmallLoop();
  EXPECT_FALSE(state().node.has_value());
  EXPECT_FALSE(session().can_undo());
}

}  // namespace
}  // namespace loopscope
