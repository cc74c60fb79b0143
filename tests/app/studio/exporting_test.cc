// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QClipboard>
#include <QDialog>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QSpinBox>
#include <QtTest>
#include <filesystem>

#include "app/session/render_command_line.h"
#include "app/studio/tile.h"
#include "render/picture_comparison.h"
#include "tests/app/studio/window_fixture.h"
#include "tests/support/program.h"

namespace loopscope {
namespace {

class ExportingTest : public WindowFixture {
 protected:
  void SetUp() override { OpenSmallLoop(); }

  const ViewRequest& Asked() { return *window().findChildren<Tile*>().front()->asked(); }

  /// Runs the command of the export dialog, and `act` while it is open.
  void InDialog(const std::function<void(QDialog*)>& act, bool wait = true) {
    QTimer::singleShot(300,
                       [&] { act(qobject_cast<QDialog*>(QApplication::activeModalWidget())); });
    window().Run("file.export");
    if (wait) WaitUntilIdle();
  }

  /// What the program, run by itself, writes for the request of the first tile.
  std::string DrawnByProgram(const std::string& name) {
    std::string arguments;
    for (const std::string& word : RenderArguments(session().path(), Asked(), name)) {
      arguments += QuotedForShell(word) + " ";
    }
    const ProgramRun run = RunLoopscope(folder(), arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    return ContentOf(folder().Path(name));
  }
};

/// The means of its blocks of kBlock x kBlock pixels: how it looks from far away.
Picture Shrunk(const Picture& picture) {
  constexpr int kBlock = 8;
  Picture small{picture.width / kBlock, picture.height / kBlock, {}};
  for (int i = 0; i < 3 * small.width * small.height; ++i) {
    const int channel = i % 3, x = i / 3 % small.width, y = i / 3 / small.width;
    int sum = 0;
    for (int k = 0; k < kBlock * kBlock; ++k) {
      const int row = kBlock * y + k / kBlock, column = kBlock * x + k % kBlock;
      sum += picture.rgb[3 * (row * picture.width + column) + channel];
    }
    small.rgb.push_back(static_cast<std::uint8_t>(sum / (kBlock * kBlock)));
  }
  return small;
}

TEST_F(ExportingTest, TheExportedPictureIsThatOfTheProgramByteForByte) {
  Play({"step.seek 120", "view.graph", "camera.set 4 3 6", "select.node 8",
        "file.export " + folder().Path("window.png")});
  const std::string exported = ContentOf(folder().Path("window.png"));
  EXPECT_GT(exported.size(), 1000u);
  EXPECT_TRUE(exported == DrawnByProgram("program.png"));
}

// The exported one has smooth edges, which would cost the window too much time.
TEST_F(ExportingTest, TheExportedPictureIsWhatTheWindowShows) {
  for (const char* view : {"view.map", "view.graph", "view.update"}) {
    SCOPED_TRACE(view);
    const std::string path = folder().Path(std::string(view) + ".png");
    Play({view, "file.export " + path});
    const PictureComparison comparison =
        Compare(Shrunk(ViewPicture()), Shrunk(ReadPng(path)), {48, 0.02});
    EXPECT_TRUE(comparison.equal) << comparison.differing_share << " " << comparison.max_difference;
  }
}

TEST_F(ExportingTest, TheCommandLineOfADarkWindowDrawsADarkPicture) {
  Play({"window.dark", "view.graph", "file.copy_command"});
  EXPECT_THAT(QApplication::clipboard()->text().toStdString(), testing::HasSubstr(" --theme dark"));
  Play({"file.export " + folder().Path("dark.png"), "window.light"});
  const Picture picture = ReadPng(folder().Path("dark.png"));
  EXPECT_LT(picture.rgb.front(), 60) << "its paper";
}

TEST_F(ExportingTest, AFilmIsMadeOfTheStepsChosenInTheDialog) {
  std::string line;
  InDialog([&](QDialog* dialog) {
    dialog->findChild<QComboBox*>()->setCurrentIndex(1);
    const auto boxes = dialog->findChildren<QSpinBox*>();
    ASSERT_EQ(boxes.size(), 6);
    boxes[2]->setValue(10);
    boxes[3]->setValue(30);
    boxes[4]->setValue(10);
    dialog->findChild<QLineEdit*>("path")->setText(
        QString::fromStdString(folder().Path("frames/")));
    line = dialog->findChild<QPlainTextEdit*>()->toPlainText().toStdString();
    dialog->accept();
  });
  EXPECT_THAT(line, testing::HasSubstr("loopscope film "));
  EXPECT_THAT(line, testing::HasSubstr("--steps 10:30:10"));
  EXPECT_EQ(window().message(), "");
  for (const char* frame : {"frame_000000.png", "frame_000001.png", "frame_000002.png"}) {
    EXPECT_EQ(ReadPng(folder().Path(std::string("frames/") + frame)).width, Asked().width);
  }
  EXPECT_FALSE(std::filesystem::exists(folder().Path("frames/frame_000003.png")));
}

TEST_F(ExportingTest, AFilmThatIsStoppedIsNoError) {
  InDialog(
      [&](QDialog* dialog) {
        dialog->findChild<QComboBox*>()->setCurrentIndex(1);
        dialog->findChild<QLineEdit*>("path")->setText(
            QString::fromStdString(folder().Path("frames/")));
        QTimer::singleShot(0, dialog, &QDialog::accept);
      },
      /*wait=*/false);
  EXPECT_FALSE(window().IsIdle());
  WaitFor([&] { return std::filesystem::exists(folder().Path("frames")); }, "it films");
  Play({"file.stop_export"});
  EXPECT_EQ(window().message(), "");
}

TEST_F(ExportingTest, TheCopiedCommandLineDrawsTheSamePicture) {
  Play({"step.seek 100", "view.submap", "file.copy_command"});
  const std::string line = QApplication::clipboard()->text().toStdString();
  ASSERT_EQ(line.rfind("loopscope ", 0), 0u) << line;
  const ProgramRun run = RunLoopscope(folder(), line.substr(std::string("loopscope ").size()));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  Play({"file.export " + folder().Path("window.png")});
  EXPECT_TRUE(ContentOf(folder().Path("window.png")) == ContentOf(folder().Path("submap.png")));
}

TEST_F(ExportingTest, APictureThatCannotBeWrittenIsTold) {
  window().Run("file.export " + folder().Path("no/such/folder/x.png"));
  WaitUntilIdle();
  EXPECT_THAT(window().message(), testing::HasSubstr("no/such/folder/x.png"));
  window().Run("file.export " + folder().Path("x.unknown"));
  WaitUntilIdle();
  EXPECT_THAT(window().message(), testing::HasSubstr("png"));
}

TEST_F(ExportingTest, APictureOfARunThatIsStillMappedCanBeExported) {
  window().Run("file.open " + CopyOfLongLog());
  WaitFor([&] { return session().last_step() > 20; }, "some scans are mapped");
  window().Run("step.seek 10");
  window().Run("file.export " + folder().Path("early.png"));
  WaitUntilIdle();
  EXPECT_EQ(window().message(), "");
  EXPECT_EQ(ReadPng(folder().Path("early.png")).width, Asked().width);
}

}  // namespace
}  // namespace loopscope
