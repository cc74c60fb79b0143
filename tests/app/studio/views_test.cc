// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <QTableView>
#include <QtTest>

#include "app/studio/layers_panel.h"
#include "app/studio/search_bar.h"
#include "app/studio/tile.h"
#include "render/charts/recording_charts.h"
#include "render/layout.h"
#include "render/views/chart_plot.h"
#include "tests/app/studio/window_fixture.h"

namespace loopscope {
namespace {

class ViewsTest : public WindowFixture {
 protected:
  void SetUp() override { OpenSmallLoop(); }

  /// Goes to the first closed loop, so that every view has something to show.
  void GoToLoop() {
    const auto& candidates = session().recording().candidates();
    const auto loop = std::find_if(candidates.begin(), candidates.end(),
                                   [](const auto& c) { return c.verdict == Verdict::kAccepted; });
    Play({"go.loop " + std::to_string(loop - candidates.begin())});
  }

  const ViewRequest& Asked(int tile = 0) {
    return *window().findChildren<Tile*>().at(tile)->asked();
  }

  QTreeWidgetItem* LayerItem(const QString& name) {
    const auto items = Find<LayersPanel>(&window())->findItems(name, Qt::MatchExactly);
    return items.isEmpty() ? nullptr : items.front();
  }

  /// The box before the name.
  void ClickLayer(const QString& name) {
    auto* const tree = Find<LayersPanel>(Raise("Layers")->parentWidget());
    const QRect row = tree->visualItemRect(LayerItem(name));
    QTest::mouseClick(tree->viewport(), Qt::LeftButton, {}, {row.left() + 11, row.center().y()});
    WaitUntilIdle();
  }

  /// Where a point of the map [m] is in the first view.
  QPoint PixelOf(const Eigen::Vector2d& point) {
    const QPoint origin = View()->rect().center() - QPoint(60, 0);
    const auto place = View()->PlaceAt(origin);
    EXPECT_TRUE(place.has_value());
    const Eigen::Vector2d pixels = (point - place->point) / place->meters_per_pixel;
    return origin + QPoint(qRound(pixels.x()), qRound(-pixels.y()));
  }

  /// Where values of the chart are in the first view.
  QPoint PixelInChart(double x, double y) {
    const ViewRequest& request = Asked();
    const Panel panel = BuildScene(session().recording(), request).panels.front();
    const SheetSize size = MakeSheetSize(request.width, request.height, 1, request.text_height);
    const ChartData data = ChartOf(session().recording(), request.chart, *request.step);
    const Eigen::Vector2d place = PlaceChart(data, panel.frame.width / panel.frame.height,
                                             TextStyleOf(size, {}), panel.camera.meters_per_pixel)
                                      .plot.At(x, y);
    const Eigen::Vector2d pixels = (place - panel.camera.center) / panel.camera.meters_per_pixel;
    return QPoint(qRound(panel.frame.center_x() + pixels.x()),
                  View()->height() - qRound(panel.frame.center_y() + pixels.y()));
  }

  void Wheel(const QPoint& position, int steps) {
    QWheelEvent event(position, View()->mapToGlobal(position), {}, {0, 120 * steps}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(View(), &event);
  }
};

TEST_F(ViewsTest, KeysShowTheViews) {
  GoToLoop();
  const ViewKind kinds[] = {ViewKind::kMap,   ViewKind::kSubmap, ViewKind::kUpdate,
                            ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph,
                            ViewKind::kTime,  ViewKind::kChart};
  for (int i = 0; i < 8; ++i) {
    QTest::keyClick(&window(), Qt::Key(Qt::Key_1 + i));
    WaitUntilIdle();
    EXPECT_EQ(state().tiles.front(), kinds[i]);
    EXPECT_EQ(window().message(), "");
    ExpectWindow("view_" + ToString(kinds[i]));
  }
}

TEST_F(ViewsTest, TwoViewsAreShownSideBySide) {
  GoToLoop();
  Play({"view.map", "tiles.two"});
  EXPECT_EQ(state().tiles.size(), 2u);
  EXPECT_TRUE(View(1)->isVisible());
  EXPECT_FALSE(View(2)->isVisible());
  ExpectWindow("two_views");
  Play({"tiles.one"});
  EXPECT_FALSE(View(1)->isVisible());
}

TEST_F(ViewsTest, FourViewsAreShownAtOnce) {
  GoToLoop();
  Play({"view.map", "tiles.four"});
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(View(i)->has_scene()) << i;
  ExpectWindow("four_views");
}

TEST_F(ViewsTest, AClickIntoATileMakesItTheOneThatKeysChange) {
  Play({"tiles.two"});
  QTest::mouseClick(View(1), Qt::LeftButton, {}, View(1)->rect().center());
  EXPECT_EQ(state().active_tile, 1);
  QTest::keyClick(&window(), Qt::Key_6);
  EXPECT_EQ(state().tiles, (std::vector<ViewKind>{ViewKind::kMap, ViewKind::kGraph}));
}

TEST_F(ViewsTest, AClickInTheListOfLayersSwitchesOneAndAnotherBack) {
  const std::set<LayerKind> usual = DefaultLayersOf(ViewKind::kMap);
  const QString name = QString::fromStdString(ToString(LayerKind::kTrajectory));
  ClickLayer(name);
  ASSERT_TRUE(Asked().layers.has_value());
  EXPECT_NE(Asked().layers->count(LayerKind::kTrajectory), usual.count(LayerKind::kTrajectory));
  EXPECT_EQ(LayerItem(name)->checkState(0) == Qt::Checked,
            Asked().layers->count(LayerKind::kTrajectory) > 0);
  ExpectWindow("layer_switched");
  ClickLayer(name);
  EXPECT_FALSE(Asked().layers.has_value());
}

TEST_F(ViewsTest, TheWheelZoomsAtThePointer) {
  const QPoint pointer(200, 150);
  const auto before = View()->PlaceAt(pointer);
  ASSERT_TRUE(before.has_value());
  Wheel(pointer, 2);
  WaitFor([&] { return Asked().width_in_meters.has_value(); }, "the camera rests");
  WaitUntilIdle();
  const auto after = View()->PlaceAt(pointer);
  ASSERT_TRUE(after.has_value());
  EXPECT_NEAR((after->point - before->point).norm(), 0.0, 1e-3);
  EXPECT_NEAR(after->meters_per_pixel, before->meters_per_pixel / (1.25 * 1.25), 1e-6);
  ExpectWindow("zoomed");
  QTest::mouseDClick(View(), Qt::LeftButton, {}, pointer);
  WaitUntilIdle();
  EXPECT_FALSE(Asked().width_in_meters.has_value()) << "all is shown again";
}

TEST_F(ViewsTest, ADragMovesTheMapWithTheHand) {
  const QPoint start(200, 150), end(260, 190);
  const auto before = View()->PlaceAt(start);
  QTest::mousePress(View(), Qt::LeftButton, {}, start);
  QTest::mouseMove(View(), (start + end) / 2);
  QTest::mouseMove(View(), end);
  QTest::mouseRelease(View(), Qt::LeftButton, {}, end);
  WaitFor([&] { return Asked().center.has_value(); }, "the camera rests");
  WaitUntilIdle();
  const auto after = View()->PlaceAt(end);
  EXPECT_NEAR((after->point - before->point).norm(), 0.0, 1e-3);
  EXPECT_FALSE(state().node.has_value()) << "a drag is no click";
}

TEST_F(ViewsTest, AClickOnANodeSelectsItInTheTable) {
  Play({"view.graph"});
  const int node = 70;
  const MapState map = StateAfterStep(session().recording(), state().step);
  QTest::mouseClick(View(), Qt::LeftButton, {}, PixelOf(map.global_from_node[node].translation));
  WaitUntilIdle();
  EXPECT_EQ(state().node, NodeId{node});
  EXPECT_EQ(Find<QTableView>(Raise("Nodes"))->currentIndex().row(), node);
}

TEST_F(ViewsTest, SlidersShowAPartOfASearch) {
  GoToLoop();
  Play({"view.search"});
  const auto sliders = Find<SearchBar>(&window())->findChildren<QSlider*>();
  ASSERT_EQ(sliders.size(), 3);
  sliders.front()->setValue(5);
  WaitUntilIdle();
  EXPECT_EQ(Asked().search.num_visits, 5);
  ExpectWindow("search_after_five_visits");
  sliders.front()->setValue(sliders.front()->maximum());
  WaitUntilIdle();
  EXPECT_FALSE(Asked().search.num_visits.has_value());
}

TEST_F(ViewsTest, SlidersRestWhereNoSearchIsShown) {
  auto* const bar = Find<SearchBar>(&window());
  Play({"step.first", "view.search"});
  EXPECT_FALSE(bar->isEnabled());
  GoToLoop();
  EXPECT_TRUE(bar->isEnabled());
}

TEST_F(ViewsTest, APointOfAChartSelectsItsLoopAndADoubleClickGoesThere) {
  Play({"view.chart"});
  const auto& candidates = session().recording().candidates();
  const auto loop = std::find_if(candidates.begin(), candidates.end(),
                                 [](const auto& c) { return c.verdict == Verdict::kAccepted; });
  const auto margin = [](const LoopCandidate& c) { return c.score - c.min_score; };
  const QPoint place = PixelInChart(loop->considered_step, margin(*loop));
  const int step = state().step;
  QTest::mouseClick(View(), Qt::LeftButton, {}, place);
  WaitUntilIdle();
  ASSERT_TRUE(session().SelectedCandidate().has_value());
  const LoopCandidate& selected = candidates[*session().SelectedCandidate()];
  EXPECT_NEAR(margin(selected), margin(*loop), 0.02);
  EXPECT_NEAR(selected.considered_step, loop->considered_step, 5);
  EXPECT_EQ(state().step, step);
  ExpectWindow("chart_point_selected");
  QTest::mouseDClick(View(), Qt::LeftButton, {}, place);
  WaitUntilIdle();
  EXPECT_EQ(state().step, std::max(selected.considered_step, selected.applied_step));
}

TEST_F(ViewsTest, ABarOfAHistogramListsItsLoops) {
  Play({"view.chart", "chart.kind residual-histogram"});
  const ChartData data =
      ChartOf(session().recording(), ChartKind::kResidualHistogram, state().step);
  const ChartBar bar = data.series.front().bars.front();
  QTest::mouseClick(View(), Qt::LeftButton, {},
                    PixelInChart(std::sqrt(bar.begin * bar.end), 0.5 * (bar.low + bar.high)));
  WaitUntilIdle();
  EXPECT_EQ(state().tables.at(TableKind::kLoops).filter.rfind("residual ", 0), 0u);
  const int num_rows = Find<QTableView>(Raise("Loops"))->model()->rowCount();
  EXPECT_GE(num_rows, bar.high - bar.low) << "a filter rounds to the digits shown";
  const auto& candidates = session().recording().candidates();
  EXPECT_LT(num_rows, std::count_if(candidates.begin(), candidates.end(),
                                    [](const auto& c) { return c.verdict == Verdict::kAccepted; }));
}

TEST_F(ViewsTest, FFramesTheSelection) {
  Play({"select.node 10"});
  QTest::keyClick(&window(), Qt::Key_F);
  WaitUntilIdle();
  const MapState map = StateAfterStep(session().recording(), state().step);
  ASSERT_TRUE(Asked().center.has_value());
  EXPECT_NEAR((*Asked().center - map.global_from_node[10].translation).norm(), 0.0, 1e-9);
  QTest::keyClick(&window(), Qt::Key_F, Qt::ShiftModifier);
  WaitUntilIdle();
  EXPECT_FALSE(Asked().center.has_value());
}

// In VTK's windows e and q end the program, s and w change surfaces, 3 is stereo, p picks, r and f
// move the camera, u calls back, and j and t change what the mouse does.
TEST_F(ViewsTest, KeysOfVtkDoNothingButWhatTheCommandsSay) {
  View()->setFocus();
  QTest::mouseClick(View(), Qt::LeftButton, {}, View()->rect().center());
  Play({"select.none"});
  for (const char key : {'e', 'q', 's', 'w', 'p', 'u', 'j', 't'}) {
    const SessionState before = state();
    const Picture picture = Screenshot();
    QTest::keyClick(View(), key);
    WaitUntilIdle();
    EXPECT_EQ(state(), before) << key;
    EXPECT_TRUE(window().isVisible()) << key;
    ExpectSame(Screenshot(), picture, std::string("key_") + key);
  }
  for (const auto& [key, command] :
       {std::pair('3', "view.update"), std::pair('r', "event.next_refused"),
        std::pair('f', "camera.frame")}) {
    Play({"view.map", "step.first"});
    const SessionState before = state();
    QTest::keyClick(View(), key);
    WaitUntilIdle();
    const SessionState by_key = state();
    session().Change("as before", before);
    Play({command});
    EXPECT_EQ(state(), by_key) << key;
  }
}

TEST_F(ViewsTest, AViewWithNothingToShowSaysSo) {
  Play({"view.submap", "step.first", "view.search"});
  EXPECT_FALSE(View()->has_scene());
  ExpectWindow("nothing_to_show");
  Play({"view.map"});
  EXPECT_TRUE(View()->has_scene());
}

TEST_F(ViewsTest, TheColoursForAnyColourVisionAreThoseOfThePictures) {
  Play({"view.graph", "theme.color_blind"});
  EXPECT_EQ(Asked().theme, Theme::kColorBlind);
  ExpectWindow("view_graph_color_blind");
}

}  // namespace
}  // namespace loopscope
