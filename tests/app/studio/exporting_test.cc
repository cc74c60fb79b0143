// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
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

  Picture Framebuffer() {
    const QImage image = View()->grabFramebuffer().convertToFormat(QImage::Format_RGB888);
    Picture picture{image.width(), image.height(), {}};
    for (int y = 0; y < picture.height; ++y) {
      const uchar* const row = image.constScanLine(y);
      picture.rgb.insert(picture.rgb.end(), row, row + 3 * picture.width);
    }
    return picture;
  }
};

TEST_F(ExportingTest, TheExportedPictureIsThatOfTheProgramByteForByte) {
  Play({"step.seek 120", "view.graph", "camera.set 4 3 6", "select.node 8",
        "file.export " + folder().Path("window.png")});
  const std::string exported = ContentOf(folder().Path("window.png"));
  EXPECT_GT(exported.size(), 1000u);
  EXPECT_EQ(exported, DrawnByProgram("program.png"));
}

TEST_F(ExportingTest, TheExportedPictureIsWhatTheWindowShows) {
  for (const char* view : {"view.map", "view.graph", "view.update"}) {
    SCOPED_TRACE(view);
    const std::string path = folder().Path(std::string(view) + ".png");
    Play({view, "file.export " + path});
    const PictureComparison comparison =
        Compare(Framebuffer(), ReadPng(path), PictureTolerance{48, 0.02});
    EXPECT_TRUE(comparison.equal) << comparison.differing_share;
    if (!comparison.equal) {
      WriteComparison(Framebuffer(), ReadPng(path), LOOPSCOPE_BINARY_DIR "/pictures/studio",
                      std::string("export_") + view);
    }
  }
}

TEST_F(ExportingTest, TheCopiedCommandLineDrawsTheSamePicture) {
  Play({"step.seek 100", "view.submap", "file.copy_command"});
  const std::string line = QApplication::clipboard()->text().toStdString();
  ASSERT_EQ(line.rfind("loopscope ", 0), 0u) << line;
  const ProgramRun run = RunLoopscope(folder(), line.substr(std::string("loopscope ").size()));
  ASSERT_EQ(run.exit_code, 0) << run.err;
  Play({"file.export " + folder().Path("window.png")});
  EXPECT_EQ(ContentOf(folder().Path("window.png")), ContentOf(folder().Path("submap.png")));
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
  window().Run("file.open " + CopyOfLog());
  WaitFor([&] { return session().last_step() > 20; }, "some scans are mapped");
  window().Run("step.seek 10");
  window().Run("file.export " + folder().Path("early.png"));
  WaitUntilIdle();
  EXPECT_EQ(window().message(), "");
  EXPECT_EQ(ContentOf(folder().Path("early.png")), DrawnByProgram("late.png"));
}

}  // namespace
}  // namespace loopscope
