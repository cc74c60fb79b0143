// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
// Runs the tests of the window in a real window, on an X server and with settings of their own.
#include <QApplication>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>
#include <cstdlib>

#include <gmock/gmock.h>

#include "tests/app/studio/x_server.h"
#include "tests/support/temporary_folder.h"

namespace {

/// Nothing of the person who runs the tests: no settings, no display, no scaling.
void SetEnvironment(const std::string& home, const std::string& display) {
  for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_RUNTIME_DIR"}) {
    setenv(name, home.c_str(), 1);
  }
  for (const char* name : {"WAYLAND_DISPLAY", "QT_STYLE_OVERRIDE", "QT_QPA_PLATFORMTHEME",
                           "QT_SCREEN_SCALE_FACTORS", "QT_FONT_DPI", "XDG_CURRENT_DESKTOP"}) {
    unsetenv(name);
  }
  setenv("DISPLAY", display.c_str(), 1);
  setenv("LC_ALL", "C.UTF-8", 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
  setenv("QT_SCALE_FACTOR", "1", 1);
}

}  // namespace

int main(int argc, char** argv) {
  testing::InitGoogleMock(&argc, argv);
  if (GTEST_FLAG_GET(list_tests)) return RUN_ALL_TESTS();
  const loopscope::TemporaryFolder home;
  const loopscope::XServer server;
  SetEnvironment(home.Path(""), server.display());
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName("loopscope");
  QApplication::setApplicationName("loopscope-studio-test");
  QApplication::setQuitOnLastWindowClosed(false);
  QApplication::setCursorFlashTime(0);  // pictures must not blink
  return RUN_ALL_TESTS();
}
