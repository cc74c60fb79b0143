// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QDockWidget>
#include <functional>
#include <initializer_list>
#include <memory>
#include <string>

#include <gmock/gmock.h>

#include "app/studio/main_window.h"
#include "app/studio/view_widget.h"
#include "render/picture.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {

/// A window of 1280 x 800 pixels on the screen, as on the day of its installation.
class WindowFixture : public ::testing::Test {
 protected:
  WindowFixture();
  ~WindowFixture() override;

  MainWindow& window() { return *window_; }
  Session& session() { return window_->session(); }
  const SessionState& state() { return session().state(); }

  /// A window after the one that there was, which is closed first.
  void OpenWindowAnew();
  void CloseWindow();
  /// Without closing it before.
  void DestroyWindow() { window_.reset(); }

  /// Runs command lines; after each the window becomes idle and has no message, or the test fails.
  void Play(std::initializer_list<std::string> lines);
  /// The small loop, mapped, looked at from its last step.
  void OpenSmallLoop();
  void WaitUntilIdle();
  /// Fails the test if `condition` does not hold soon.
  void WaitFor(const std::function<bool()>& condition, const char* what);

  /// What the window looks like.
  Picture Screenshot();
  /// What the view in a tile shows, to the pixel.
  Picture ViewPicture(int tile = 0);
  /// Two pictures that differ are left as `name`.*.png in the results, to be looked at.
  void ExpectSame(const Picture& actual, const Picture& expected, const std::string& name);
  /// Expects the window to look like tests/baselines/studio/`name`.png.
  void ExpectWindow(const std::string& name);
  /// Likewise of a part or a dialog.
  void ExpectWidget(QWidget* widget, const std::string& name);

  /// What is in the dock with this title, after a click on its tab.
  QWidget* Raise(const char* title);
  /// The child of this kind within `parent`; there must be one.
  template <typename Widget>
  Widget* Find(QWidget* parent) {
    Widget* const widget = parent->findChild<Widget*>();
    EXPECT_NE(widget, nullptr);
    return widget;
  }
  /// The view in a tile, from the upper left.
  ViewWidget* View(int tile = 0);

  /// A folder for the files of this test.
  const TemporaryFolder& folder() const { return folder_; }

  /// Files that are the same for all tests of a program and must not be changed.
  static const std::string& SmallLoopRecording();
  static const std::string& SmallLoopLog();
  /// A copy of the log of the small loop, beside which a recording can be made.
  std::string CopyOfLog() const;
  /// Likewise of the bundled log: a second is long enough to do something while it is mapped.
  std::string CopyOfLongLog() const;

 private:
  TemporaryFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

}  // namespace loopscope
