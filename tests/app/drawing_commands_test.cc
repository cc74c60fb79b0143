// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// `loopscope render` and `loopscope film`.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "render/picture.h"
#include "tests/app/command_test.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

TEST_F(CommandTest, RenderDrawsEveryViewWithoutADisplay) {
  for (const std::string view : {"map", "submap", "update", "match", "search", "graph"}) {
    const ProgramRun run =
        Run("render run.loopscope --size 400x300 --view " + view +
            (view == "search" ? " --node 50 --submap 0" : "") + " -o " + view + ".png");
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(run.out, view + ".png\n");
    const Picture picture = ReadPng(folder_.Path(view + ".png"));
    EXPECT_EQ(picture.width, 400);
    EXPECT_EQ(picture.height, 300);
  }
}

TEST_F(CommandTest, RenderShowsTheStateAfterAStepOrTime) {
  const std::string render = "render run.loopscope --size 400x300 ";
  ASSERT_EQ(Run(render + "-o step.png --step 25").exit_code, 0);
  ASSERT_EQ(Run(render + "-o time.png --time 5.01").exit_code, 0);
  ASSERT_EQ(Run(render + "-o stamp.png --time 1000000005.01").exit_code, 0);
  ASSERT_EQ(Run(render + "-o other.png --step 26").exit_code, 0);
  const Picture at_step = ReadPng(folder_.Path("step.png"));
  EXPECT_TRUE(at_step == ReadPng(folder_.Path("time.png")));
  EXPECT_TRUE(at_step == ReadPng(folder_.Path("stamp.png")));
  EXPECT_FALSE(at_step == ReadPng(folder_.Path("other.png")));
}

TEST_F(CommandTest, NamesThatAreNoTextAreDrawnAndPrintedAllTheSame) {
  const std::string name = "B\xfc.";  // as a file is called that Latin-1 once named
  folder_.Write(name + "log", OfficeExcerpt(60));
  ASSERT_EQ(Run("map " + name + "log -o " + name + "loopscope").exit_code, 0);
  for (const std::string ending : {"png", "svg", "pdf"}) {
    const ProgramRun run =
        Run("render " + name + "loopscope --title " + name + " -o picture." + ending);
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_EQ(run.err, "");
  }
  const ProgramRun run = Run("evaluate " + name + "loopscope --json");
  EXPECT_EQ(run.err, "");
  EXPECT_THAT(run.out, HasSubstr("\"B\uFFFD.loopscope\""));
}

TEST_F(CommandTest, RenderDrawsLayersAsClearAsAsked) {
  const std::string render = "render run.loopscope --size 400x300 ";
  ASSERT_EQ(Run(render + "-o full.png --layers grid:1,trajectory").exit_code, 0);
  ASSERT_EQ(Run(render + "-o same.png --layers grid,trajectory").exit_code, 0);
  ASSERT_EQ(Run(render + "-o faint.png --layers grid:0.3,trajectory").exit_code, 0);
  const Picture full = ReadPng(folder_.Path("full.png"));
  EXPECT_TRUE(full == ReadPng(folder_.Path("same.png")));
  EXPECT_FALSE(full == ReadPng(folder_.Path("faint.png")));
}

TEST_F(CommandTest, RenderDrawsAPartOfASearch) {
  const std::string render = "render run.loopscope --view search --node 50 --submap 0 ";
  for (const std::string part : {"--visits 3", "--height 2", "--angle 1"}) {
    const ProgramRun run = Run(render + "--size 400x300 -o part.png " + part);
    EXPECT_EQ(run.exit_code, 0) << run.err;
  }
  ExpectRefused(render + "--chart costs", "--chart costs: expected --view chart");
  ExpectRefused(render + "--visits -1", "visits -1 of the search: expected 0 to ");
  ExpectRefused(render + "--height 7", "height 7 of the search: expected 0 to 3");
  ExpectRefused(render + "--angle 200", "angle index 200 of the search: expected -");
  ExpectRefused("render run.loopscope --angle 1", "view map has no visits, heights or angles");
}

TEST_F(CommandTest, RenderNamesThePictureAfterRunAndView) {
  const ProgramRun run = Run("render run.loopscope --view graph --size 320x240");
  EXPECT_EQ(run.out, "run.graph.png\n");
  EXPECT_TRUE(Exists("run.graph.png"));
}

TEST_F(CommandTest, RenderWritesVectorPicturesByTheNameOfTheFile) {
  const std::string render = "render run.loopscope --size 400x300 --view graph -o ";
  ASSERT_EQ(Run(render + "a.svg").exit_code, 0);
  EXPECT_THAT(ContentOf(folder_.Path("a.svg")), HasSubstr("viewBox=\"0 0 400 300\""));
  ASSERT_EQ(Run(render + "a.pdf").exit_code, 0);
  EXPECT_EQ(ContentOf(folder_.Path("a.pdf")).substr(0, 5), "%PDF-");
  ExpectRefused(render + "a.bmp", "a.bmp: expected a name that ends in .png, .svg or .pdf");
  EXPECT_FALSE(Exists("a.bmp"));
}

TEST_F(CommandTest, RenderRefusesWhatTheRecordingDoesNotHave) {
  const std::string render = "render run.loopscope ";
  ExpectRefused(render + "--view nonsense", "map, submap, update, match, search");
  ExpectRefused(render + "--step 100", "expected 0 to 99");
  ExpectRefused(render + "--step -1", "expected 0 to 99");
  ExpectRefused(render + "--time 20", "no scan at --time 20; expected 0 to 19.8");
  ExpectRefused(render + "--view submap --submap 99", "there is no submap 99");
  ExpectRefused(render + "--view match --node 9999", "there is no node 9999");
  ExpectRefused(render + "--layers nonsense", "nonsense");
  ExpectRefused(render + "--layers grid:1.5", "expected an opacity of 0 to 1 behind the colon");
  ExpectRefused(render + "--layers grid:", "expected an opacity of 0 to 1 behind the colon");
  ExpectRefused(render + "--backend nonsense", "nonsense");
  ExpectRefused(render + "--theme nonsense", "nonsense");
  for (const std::string size : {"1", "1x1", "x", "axb", "400x300x", "99999x300"}) {
    ExpectRefused(render + "--size " + size, "--size " + size + ": expected width and height");
  }
  ExpectRefused(render + "--size 320x240 -o none/a.png", "none/a.png: cannot be written");
}

TEST_F(CommandTest, FilmDrawsARangeOfStepsAsRenderDoes) {
  const std::string view = " --view graph --size 400x300 --center 0,0 --width 20 ";
  const ProgramRun run = Run("film run.loopscope --steps 10:99:40" + view + "-o frames");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "frames: 3 frames, 0.1 s\n");
  ASSERT_EQ(Run("render run.loopscope --step 50" + view + "-o 50.png").exit_code, 0);
  EXPECT_TRUE(ReadPng(folder_.Path("frames/frame_000001.png")) == ReadPng(folder_.Path("50.png")));
  EXPECT_FALSE(Exists("frames/frame_000003.png"));
}

TEST_F(CommandTest, FilmLeavesOutStepsWithNothingToShow) {
  const std::string film = "film run.loopscope --view match --size 400x300 -o frames --steps ";
  const ProgramRun run = Run(film + "0:2");
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.out, "frames: 2 frames, 0.1 s; left out 1 steps with nothing to show\n");
  EXPECT_TRUE(Exists("frames/frame_000001.png"));
  ExpectRefused(film + "0:0", "the scan of step 0 was not matched");
}

TEST_F(CommandTest, FilmRefusesWhatItCannotShoot) {
  const std::string film = "film run.loopscope --size 320x240 ";
  ExpectRefused(film + "--steps 0:100 -o a.mp4", "steps 0:100: expected FIRST:LAST");
  ExpectRefused(film + "--steps 0:9 -o a.mov", "a.mov: expected a name that ends in .mp4");
  ExpectRefused(film + "--steps 0:9 -o none/a.mp4", "none/a.mp4: cannot be written");
  ExpectRefused(film + "--steps 0:9 --fps 0 -o a.mp4", "--fps");
  ExpectRefused(film + "--steps 0:9 --fps nan -o a.mp4", "--fps");
  EXPECT_FALSE(Exists("a.mp4"));
}

}  // namespace
}  // namespace loopscope
