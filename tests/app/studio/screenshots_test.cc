// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/loop_table.h"
#include "app/session/table_filter.h"
#include "tests/app/studio/window_fixture.h"
#include "tests/render/pictures/expect_picture.h"
#include "tests/support/program.h"

namespace loopscope {
namespace {

/// The window on the run of the demo, as the README shows it: each picture is its own baseline.
class ScreenshotsTest : public WindowFixture {
 protected:
  void SetUp() override {
    const ProgramRun run = RunLoopscope(
        folder(), std::string("map " LOOPSCOPE_SOURCE_DIR "/datasets/office.log.gz -o ") +
                      "office.loopscope");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    Play({"file.open " + folder().Path("office.loopscope"), "table.filter loops verdict = closed",
          "table.sort_down loops residual"});
  }

  /// Of all loops that were closed.
  int WorstLoop() {
    const Recording& recording = session().recording();
    LoopTable loops;
    loops.Append(recording);
    loops.Show(recording, session().map());
    const Table& table = loops.table();
    return RowsOf(table, TableFilter("verdict = closed", table.columns()),
                  table.ColumnOf("residual"), true)
        .front();
  }

  void ExpectScreenshot(const std::string& name) {
    ExpectPicture(Screenshot(), name,
                  {LOOPSCOPE_SOURCE_DIR "/screenshots", LOOPSCOPE_BINARY_DIR "/screenshots"});
  }
};

TEST_F(ScreenshotsTest, TheWorstLoopInTheGraph) {
  Play({"view.graph", "select.loops " + std::to_string(WorstLoop())});
  ExpectScreenshot("studio");
}

TEST_F(ScreenshotsTest, ItsSearchInADarkWindow) {
  Play({"window.dark", "view.search", "select.loops " + std::to_string(WorstLoop())});
  ExpectScreenshot("studio-search");
}

}  // namespace
}  // namespace loopscope
