// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/render_command_line.h"

#include <gtest/gtest.h>

#include "core/io/recording_file.h"
#include "render/headless/painter.h"
#include "tests/support/office_excerpt.h"
#include "tests/support/program.h"

namespace loopscope {
namespace {

/// The first part of every line, which a user's shell finds the program by.
constexpr std::size_t kLengthOfName = std::string_view("loopscope ").size();

/// Every field of a request, in all views, with values that are hard to write and to quote.
std::vector<ViewRequest> Requests() {
  std::vector<ViewRequest> requests(9);
  for (ViewRequest& request : requests) {
    request.width = 400;
    request.height = 300;
  }
  requests[0].title = "--step 'a' \"b\" $c";
  requests[1].step = 40;
  requests[1].center = Eigen::Vector2d(-1.0 / 3.0, 0.1 + 0.2);
  requests[1].width_in_meters = 20.0 / 3.0;
  requests[2].view = ViewKind::kSubmap;
  requests[2].submap = SubmapId{1};
  requests[3].view = ViewKind::kUpdate;
  requests[3].node = NodeId{12};
  requests[3].theme = Theme::kColorBlind;
  requests[4].view = ViewKind::kMatch;
  requests[4].node = NodeId{30};
  requests[5].view = ViewKind::kSearch;
  requests[5].node = NodeId{50};
  requests[5].submap = SubmapId{0};
  requests[6].view = ViewKind::kGraph;
  requests[6].layers = {LayerKind::kNodes, LayerKind::kInter, LayerKind::kTrajectory};
  requests[7].view = ViewKind::kGraph;
  requests[7].center = Eigen::Vector2d(2.0, -1e-3);
  requests[8].view = ViewKind::kTime;
  requests[8].marked = {{NodeId{50}, SubmapId{0}}};
  requests[8].theme = Theme::kDarkColorBlind;
  requests[8].plain = true;
  requests[7].width_in_meters = 2.0;
  requests[7].height_in_meters = 3.0;
  return requests;
}

TEST(RenderCommandLine, DrawsTheVeryPictureThatTheRequestAsksFor) {
  const TemporaryFolder folder;
  folder.Write("a.log", OfficeExcerpt(100));
  const std::string run = "it's a run.loopscope";
  const ProgramRun mapped =
      RunLoopscope(folder, "map a.log --set TRAJECTORY_BUILDER_2D.submaps.num_range_data=10 -o " +
                               QuotedForShell(run));
  ASSERT_EQ(mapped.exit_code, 0) << mapped.err;
  const Recording recording = ReadRecording(folder.Path(run));
  Painter painter(Backend::kAuto);
  for (const ViewRequest& request : Requests()) {
    const std::string line = CommandLine(RenderArguments(run, request, "-a b.png"));
    const ProgramRun drawn = RunLoopscope(folder, line.substr(kLengthOfName));
    ASSERT_EQ(drawn.exit_code, 0) << line << drawn.err;
    WritePng(painter.Draw(recording, request), folder.Path("expected.png"));
    EXPECT_EQ(ContentOf(folder.Path("-a b.png")), ContentOf(folder.Path("expected.png"))) << line;
  }
}

}  // namespace
}  // namespace loopscope
