// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QtTest>

#include "app/studio/palette_dialog.h"
#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

class SettingsTest : public WindowFixture {
 protected:
  QStringList RecentFiles() {
    QStringList files;
    for (QMenu* const menu : window().findChildren<QMenu*>()) {
      if (menu->title() != "Open recent") continue;
      for (QAction* const action : menu->actions()) files.append(action->text());
    }
    return files;
  }

  PaletteDialog* OpenPalette() {
    QTest::keyClick(&window(), Qt::Key_P, Qt::ControlModifier);
    auto* const palette = window().findChild<PaletteDialog*>();
    EXPECT_TRUE(palette != nullptr && palette->isVisible());
    return palette;
  }
};

TEST_F(SettingsTest, RecentFilesAreThereInTheNextWindow) {
  OpenSmallLoop();
  EXPECT_EQ(RecentFiles(), QStringList{QString::fromStdString(SmallLoopRecording())});
  OpenWindowAnew();
  EXPECT_EQ(RecentFiles(), QStringList{QString::fromStdString(SmallLoopRecording())});
  EXPECT_FALSE(session().has_recording());
}

TEST_F(SettingsTest, AFileThatCannotBeOpenedIsNotRemembered) {
  window().Run("file.open " + folder().Path("missing.loopscope"));
  WaitUntilIdle();
  EXPECT_EQ(RecentFiles(), QStringList());
}

TEST_F(SettingsTest, DocksThatWereClosedAndTornOffComeBackToWhereTheyWere) {
  OpenSmallLoop();
  const Picture first = Screenshot();
  auto* const layers = window().findChild<QDockWidget*>("Layers");
  auto* const loops = window().findChild<QDockWidget*>("Loops");
  layers->close();
  loops->setFloating(true);
  OpenWindowAnew();
  OpenSmallLoop();
  EXPECT_TRUE(window().findChild<QDockWidget*>("Layers")->isHidden()) << "it is remembered";
  EXPECT_TRUE(window().findChild<QDockWidget*>("Loops")->isFloating()) << "likewise";
  Play({"window.reset_layout"});
  ExpectSame(Screenshot(), first, "reset_layout");
}

TEST_F(SettingsTest, ADarkWindowIsDarkTheNextTime) {
  Play({"window.dark"});
  OpenWindowAnew();
  ExpectWindow("start_dark");
  OpenSmallLoop();
  Play({"view.graph", "select.pair 20 0"});
  ExpectWindow("dark");
}

TEST_F(SettingsTest, AThemeChangesTheWindowThatIsOpen) {
  OpenSmallLoop();
  Play({"window.dark"});
  const Picture dark = Screenshot();
  Play({"window.light"});
  const Picture light = Screenshot();
  OpenWindowAnew();
  OpenSmallLoop();
  ExpectSame(Screenshot(), light, "light_at_once");
  Play({"window.dark"});
  ExpectSame(Screenshot(), dark, "dark_at_once");
}

TEST_F(SettingsTest, ThePaletteFindsACommandByItsWordsAndRunsIt) {
  OpenSmallLoop();
  PaletteDialog* const palette = OpenPalette();
  auto* const text = Find<QLineEdit>(palette);
  QTest::keyClicks(text, "scan first");
  EXPECT_EQ(Find<QListWidget>(palette)->count(), 1);
  QTest::keyClick(text, Qt::Key_Return);
  WaitUntilIdle();
  EXPECT_EQ(state().step, 0);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
}

TEST_F(SettingsTest, ThePaletteTakesArguments) {
  OpenSmallLoop();
  auto* const text = Find<QLineEdit>(OpenPalette());
  QTest::keyClicks(text, "step.seek 42");
  QTest::keyClick(text, Qt::Key_Return);
  WaitUntilIdle();
  EXPECT_EQ(state().step, 42);
}

TEST_F(SettingsTest, ThePaletteListsWhatIsPossible) {
  OpenSmallLoop();
  PaletteDialog* const palette = OpenPalette();
  QTest::keyClicks(Find<QLineEdit>(palette), "loop");
  ExpectWidget(palette, "palette");
  QTest::keyClick(palette, Qt::Key_Escape);
  EXPECT_EQ(QApplication::activePopupWidget(), nullptr);
  EXPECT_TRUE(window().isVisible());
}

TEST_F(SettingsTest, HShowsTheKeys) {
  bool was_shown = false;
  QTimer::singleShot(300, [&] {
    QWidget* const sheet = QApplication::activeModalWidget();
    was_shown = sheet != nullptr;
    if (!was_shown) return;
    ExpectWidget(sheet, "keys");
    sheet->close();
  });
  QTest::keyClick(&window(), Qt::Key_H);
  WaitFor([&] { return was_shown; }, "the keys are shown");
}

}  // namespace
}  // namespace loopscope
