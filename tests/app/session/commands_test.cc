// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/commands.h"

#include <set>
#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

class FakeHost : public SessionHost {
 public:
  void Open(const std::string& path) override { calls.push_back("open " + path); }
  void OpenDemo() override { calls.push_back("demo"); }
  void MapAgain() override { calls.push_back("map again"); }
  void StopMapping() override { calls.push_back("stop"); }
  void StopExport() override { calls.push_back("stop export"); }
  void ResetLayout() override { calls.push_back("reset layout"); }
  void Export(const std::string& path) override { calls.push_back("export " + path); }
  void CopyCommandLine() override { calls.push_back("copy"); }
  void ShowKeys() override { calls.push_back("keys"); }
  void ShowPalette() override { calls.push_back("palette"); }
  void SetWindowTheme(const std::string& name) override { calls.push_back(name); }
  void Quit() override { calls.push_back("quit"); }

  std::vector<std::string> calls;
};

class SessionCommandsTest : public testing::Test {
 protected:
  SessionCommandsTest() { session_.Load("run.loopscope", SmallLoopRun()); }

  const SessionState& Run(const std::string& line) {
    RunCommand(line, &session_, &host_);
    return session_.state();
  }

  std::string ErrorOf(const std::string& line) {
    try {
      Run(line);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "no error";
  }

  Session session_;
  FakeHost host_;
};

TEST_F(SessionCommandsTest, HaveNamesAndKeysOfTheirOwn) {
  std::set<std::string> names, keys;
  for (const Command& command : Commands()) {
    EXPECT_TRUE(names.insert(command.name).second) << command.name;
    for (const std::string& key : command.keys) EXPECT_TRUE(keys.insert(key).second) << key;
    EXPECT_FALSE(command.title.empty());
    EXPECT_TRUE(command.run) << command.name;
    EXPECT_TRUE(command.is_possible) << command.name;
  }
}

TEST_F(SessionCommandsTest, StepInsideOfTheRecording) {
  const int last = session_.last_step();
  EXPECT_EQ(Run("step.next").step, last);
  EXPECT_EQ(Run("step.first").step, 0);
  EXPECT_EQ(Run("step.previous").step, 0);
  EXPECT_EQ(Run("step.seek 12").step, 12);
  EXPECT_EQ(Run("step.next").step, 13);
  EXPECT_EQ(Run("step.forward").step, 113);
  EXPECT_EQ(Run("step.back").step, 13);
  EXPECT_EQ(Run("step.seek 999999").step, last);
  EXPECT_EQ(Run("edit.undo").step, last) << "all steps in a row are one";
}

TEST_F(SessionCommandsTest, GoToTheScanOfTheSelectedNode) {
  const int last = session_.last_step();
  EXPECT_EQ(Run("step.node").step, last) << "nothing is selected";
  Run("select.node 20");
  EXPECT_EQ(Run("step.node").step, session_.recording().nodes()[20].step);
  EXPECT_EQ(session_.state().node, NodeId{20}) << "it stays selected";
}

TEST_F(SessionCommandsTest, GoFromEventToEvent) {
  Run("step.first");
  const int loop = Run("event.next_loop").step;
  const auto& candidates = session_.recording().candidates();
  EXPECT_TRUE(std::any_of(candidates.begin(), candidates.end(), [&](const auto& candidate) {
    return candidate.verdict == Verdict::kAccepted && candidate.applied_step == loop;
  }));
  EXPECT_LT(Run("event.previous_optimization").step, loop);
  Run("step.last");
  const int last = session_.state().step;
  EXPECT_EQ(Run("event.next").step, last);
}

TEST_F(SessionCommandsTest, ShowOtherViewsInOneTwoOrFourTiles) {
  EXPECT_EQ(Run("view.graph").tiles, std::vector<ViewKind>{ViewKind::kGraph});
  const std::vector<ViewKind> two{ViewKind::kGraph, ViewKind::kMap};
  EXPECT_EQ(Run("tiles.two").tiles, two);
  Run("tile.select 1");
  EXPECT_EQ(Run("view.search").tiles[1], ViewKind::kSearch);
  const std::vector<ViewKind> four = Run("tiles.four").tiles;
  EXPECT_EQ(four.size(), 4u);
  EXPECT_EQ(std::set<ViewKind>(four.begin(), four.end()).size(), 4u) << "no view twice";
  EXPECT_EQ(four[0], ViewKind::kSearch) << "the active one stays";
  EXPECT_THAT(ErrorOf("tile.select 4"), HasSubstr("expected 0 to 3"));
}

TEST_F(SessionCommandsTest, SwitchLayersOfTheActiveView) {
  Run("layer.toggle nodes");
  EXPECT_EQ(session_.RequestOf(0).layers->count(LayerKind::kNodes), 1u);
  EXPECT_EQ(session_.RequestOf(0).layers->count(LayerKind::kGrid), 1u);
  Run("layer.toggle nodes");
  EXPECT_FALSE(session_.RequestOf(0).layers) << "as the view has them";
  EXPECT_THAT(ErrorOf("layer.toggle odds"), HasSubstr("view map has no layer 'odds'"));
  EXPECT_THAT(ErrorOf("layer.toggle walls"), HasSubstr("walls"));
}

TEST_F(SessionCommandsTest, MoveTheCameraOfTheActiveView) {
  Run("camera.set 1.5 -2 30");
  EXPECT_EQ(*session_.RequestOf(0).center, Eigen::Vector2d(1.5, -2.0));
  EXPECT_EQ(*session_.RequestOf(0).width_in_meters, 30.0);
  Run("camera.fit");
  EXPECT_FALSE(session_.RequestOf(0).center);
  EXPECT_THAT(ErrorOf("camera.set 1 2"), HasSubstr("expected 3 numbers"));
  EXPECT_THAT(ErrorOf("camera.set 1 2 0"), HasSubstr("above 0"));
  EXPECT_THAT(ErrorOf("camera.set 1 2 nan"), HasSubstr("expected 3 numbers"));
}

TEST_F(SessionCommandsTest, ChooseWhatTheChartShows) {
  Run("view.chart");
  EXPECT_EQ(session_.RequestOf(0).chart, ChartKind::kScores);
  Run("chart.kind costs");
  EXPECT_EQ(session_.RequestOf(0).chart, ChartKind::kCosts);
  EXPECT_EQ(Run("edit.undo").chart, ChartKind::kScores);
  EXPECT_THAT(ErrorOf("chart.kind pies"), HasSubstr("expected one of scores"));
  EXPECT_THAT(ErrorOf("camera.set 1 2 3"), HasSubstr("view chart has no map"));
}

TEST_F(SessionCommandsTest, GoToALoopShowsItsPairWhenItWasClosed) {
  const int index = FirstCandidateWith(SmallLoopRun(), Verdict::kAccepted);
  const LoopCandidate& candidate = SmallLoopRun().candidates()[index];
  const SessionState& state = Run("go.loop " + std::to_string(index));
  EXPECT_EQ(state.node, candidate.node);
  EXPECT_EQ(state.submap, candidate.submap);
  EXPECT_EQ(state.step, candidate.applied_step);
  const MapState map = StateAfterStep(SmallLoopRun(), state.step);
  const ViewRequest request = session_.RequestOf(0);
  ASSERT_TRUE(request.center);
  const auto node = map.global_from_node[candidate.node.index].translation;
  EXPECT_LT((node - *request.center).norm(), 0.5 * *request.width_in_meters);
}

TEST_F(SessionCommandsTest, RefuseWhatDoesNotExist) {
  EXPECT_THAT(ErrorOf("go.node 99999"), HasSubstr("there is no node 99999: expected 0 to "));
  EXPECT_THAT(ErrorOf("select.submap -1"), HasSubstr("there is no submap -1"));
  EXPECT_THAT(ErrorOf("go.loop x"), HasSubstr("expected a whole number"));
  EXPECT_THAT(ErrorOf("step.sek 3"), HasSubstr("there is step.seek"));
  EXPECT_THAT(ErrorOf("table.filter cats x"), HasSubstr("expected loops, submaps or nodes"));
}

TEST_F(SessionCommandsTest, AreNotRunWhileTheyAreNotPossible) {
  Session empty;
  RunCommand("step.next", &empty, &host_);
  RunCommand("file.export x.png", &empty, &host_);
  EXPECT_EQ(empty.state(), SessionState());
  EXPECT_TRUE(host_.calls.empty());
}

TEST_F(SessionCommandsTest, AskTheHostForFilesAndDialogs) {
  Run("file.open a b.log");
  Run("file.export x.png");
  Run("window.dark");
  EXPECT_THAT(host_.calls, testing::ElementsAre("open a b.log", "export x.png", "dark"));
}

TEST_F(SessionCommandsTest, FilterAndSortTables) {
  Run("table.filter loops score > 0.5 and verdict = closed");
  const SessionState& state = Run("table.sort_down loops score");
  const TableSettings& loops = state.tables.at(TableKind::kLoops);
  EXPECT_EQ(loops.filter, "score > 0.5 and verdict = closed");
  EXPECT_EQ(loops.sort_by, "score");
  EXPECT_TRUE(loops.descending);
  EXPECT_EQ(state.tables.count(TableKind::kNodes), 0u);
}

TEST_F(SessionCommandsTest, AreFoundInThePaletteByTheirWords) {
  EXPECT_TRUE(MatchesPalette(CommandNamed("event.next_loop"), "next CLOSED"));
  EXPECT_TRUE(MatchesPalette(CommandNamed("step.seek"), "step.se"));
  EXPECT_FALSE(MatchesPalette(CommandNamed("event.next_loop"), "next opened"));
}

TEST_F(SessionCommandsTest, SelectsOneLoopAndMarksTheOthersBesideIt) {
  const SessionState& state = Run("select.loops 5 2 7");
  EXPECT_EQ(session_.SelectedCandidate(), 5);
  EXPECT_EQ(state.loops, (std::vector<int>{2, 7}));
  EXPECT_TRUE(Run("select.node 3").loops.empty());
  EXPECT_THAT(ErrorOf("select.loops 5 999999"), HasSubstr("there is no loop 999999"));
  EXPECT_THAT(ErrorOf("select.loops"), HasSubstr("expected one loop"));
}

TEST_F(SessionCommandsTest, FramesAPairByItsWidthAndItsHeight) {
  const SessionState& state = Run("select.pair 60 0");
  const MapState map = StateAfterStep(session_.recording(), state.step);
  const Eigen::Vector2d apart =
      map.global_from_node[60].translation - map.global_from_submap[0].translation;
  const ViewCamera camera = *Run("camera.frame").views.at(ViewKind::kMap).camera;
  EXPECT_GE(camera.width_in_meters, std::abs(apart.x()));
  EXPECT_GE(camera.height_in_meters, std::abs(apart.y()));
}

}  // namespace
}  // namespace loopscope
