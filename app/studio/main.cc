// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QApplication>
#include <QCommandLineParser>
#include <QSettings>
#include <QSurfaceFormat>
#include <QVTKOpenGLNativeWidget.h>

#include "app/studio/main_window.h"
#include "app/studio/theme.h"

int main(int argc, char** argv) {
  QSurfaceFormat::setDefaultFormat(QVTKOpenGLNativeWidget::defaultFormat());
  QApplication application(argc, argv);
  QApplication::setOrganizationName("loopscope");
  QApplication::setApplicationName("loopscope-studio");
  QCommandLineParser parser;
  parser.setApplicationDescription("The window in which one debugs loop closures.");
  parser.addHelpOption();
  parser.addPositionalArgument("FILE", "recording (*.loopscope) to open, or log to map",
                               "[RUN | LOG]");
  parser.process(application);

  loopscope::ApplyWindowTheme(QSettings().value("theme", "light").toString());
  loopscope::MainWindow window;
  window.show();
  if (!parser.positionalArguments().isEmpty()) {
    window.Run("file.open " + parser.positionalArguments().front().toStdString());
  }
  return QApplication::exec();
}
