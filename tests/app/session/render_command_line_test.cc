// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/render_command_line.h"

#include <cstdlib>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

TEST(RenderCommandLine, LeavesOutWhatIsLeftToTheView) {
  EXPECT_EQ(CommandLine(RenderArguments("run.loopscope", ViewRequest(), "map.png")),
            "loopscope render run.loopscope --view map -o map.png");
}

TEST(RenderCommandLine, SaysAllThatTheRequestSays) {
  ViewRequest request;
  request.view = ViewKind::kSearch;
  request.step = 812;
  request.node = NodeId{57};
  request.submap = SubmapId{3};
  request.layers = {LayerKind::kLabels, LayerKind::kGrid};
  request.center = Eigen::Vector2d(1.5, -2.25);
  request.width_in_meters = 12.5;
  request.width = 1920;
  request.height = 1080;
  request.theme = Theme::kColorBlind;
  request.title = "Loop 7";
  EXPECT_EQ(CommandLine(RenderArguments("run.loopscope", request, "a.png")),
            "loopscope render run.loopscope --view search --step 812 --node 57 --submap 3 --layers "
            "grid,labels --center 1.5,-2.25 --width 12.5 --size 1920x1080 --theme color-blind "
            "--title 'Loop 7' -o a.png");
}

TEST(RenderCommandLine, GivesNumbersTheDigitsThatTheyNeed) {
  ViewRequest request;
  request.center = Eigen::Vector2d(0.1 + 0.2, 1.0 / 3.0);
  request.width_in_meters = 1e-7;
  EXPECT_EQ(CommandLine(RenderArguments("r", request, "o")),
            "loopscope render r --view map --center 0.30000000000000004,0.3333333333333333 "
            "--width 1e-07 -o o");
}

TEST(RenderCommandLine, TiesWhatLooksLikeAnOptionToItsOwn) {
  ViewRequest request;
  request.center = Eigen::Vector2d(-1.0, 2.0);
  request.title = "--step";
  EXPECT_EQ(CommandLine(RenderArguments("-run", request, "-out.png")),
            "loopscope render ./-run --view map --center=-1,2 --title=--step -o ./-out.png");
}

TEST(RenderCommandLine, SaysFromWhichSideToLookAndWhatToChart) {
  ViewRequest time;
  time.view = ViewKind::kTime;
  time.azimuth = -45.5;
  time.elevation = 0.0;
  EXPECT_EQ(CommandLine(RenderArguments("r", time, "o")),
            "loopscope render r --view time --azimuth=-45.5 --elevation 0 -o o");
  ViewRequest chart;
  chart.view = ViewKind::kChart;
  EXPECT_EQ(CommandLine(RenderArguments("r", chart, "o")), "loopscope render r --view chart -o o");
  chart.chart = ChartKind::kResidualHistogram;
  EXPECT_EQ(CommandLine(RenderArguments("r", chart, "o")),
            "loopscope render r --view chart --chart residual-histogram -o o");
}

TEST(RenderCommandLine, SaysWhatIsMarkedAndWhatIsLeftOut) {
  ViewRequest request;
  request.marked = {{NodeId{57}, SubmapId{3}}, {NodeId{60}, SubmapId{4}}};
  request.theme = Theme::kDark;
  request.plain = true;
  request.height_in_meters = 4.5;
  EXPECT_EQ(
      CommandLine(RenderArguments("r", request, "o")),
      "loopscope render r --view map --mark 57:3,60:4 --min-height 4.5 --theme dark --plain -o o");
}

TEST(FilmCommandLine, SaysWhichStepsAndNotTheOneThatIsLookedAt) {
  ViewRequest request;
  request.view = ViewKind::kGraph;
  request.step = 7;
  EXPECT_EQ(CommandLine(FilmArguments("r", request, {10, 90, 5, 12.5}, "o.mp4")),
            "loopscope film r --view graph --steps 10:90:5 --fps 12.5 -o o.mp4");
}

TEST(RenderCommandLine, QuotesPaths) {
  EXPECT_EQ(CommandLine(RenderArguments("my run.loopscope", ViewRequest(), "it's.png")),
            "loopscope render 'my run.loopscope' --view map -o 'it'\\''s.png'");
}

TEST(RenderCommandLine, RefusesAPictureWithoutLayers) {
  ViewRequest request;
  request.layers.emplace();
  EXPECT_EQ(MessageOf([&] { CommandLine(RenderArguments("r", request, "o")); }),
            "no layers: expected one at least for a command line");
  EXPECT_THROW(CommandLine(RenderArguments("r", request, "o")), std::invalid_argument);
}

TEST(QuotedForShell, IsTheSameWordInAShell) {
  const TemporaryFolder folder;
  const std::string file = folder.Path("out");
  for (const std::string word :
       {"", "plain", "a b", "it's", "'", "$HOME", "`ls`", "\"q\"", "a\\b", "*", "~", "a;b", "a\nb",
        "#", "!", "<>|&()", "gr\xc3\xbc\xc3\x9f"}) {
    const std::string command = "printf %s " + QuotedForShell(word) + " > '" + file + "'";
    ASSERT_EQ(std::system(command.c_str()), 0) << command;
    EXPECT_EQ(ContentOf(file), word);
  }
  EXPECT_EQ(QuotedForShell("a/b-c_1.png"), "a/b-c_1.png");
  EXPECT_EQ(QuotedForShell(""), "''");
}

}  // namespace
}  // namespace loopscope
