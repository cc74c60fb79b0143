// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <algorithm>
#include <iterator>
#include <vtkActor.h>
#include <vtkProperty.h>
#include <vtkTextActor.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/large_recording.h"
#include "tests/support/mapped_log.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::Contains;
using testing::Not;
using testing::StartsWith;

constexpr ViewKind kAllViews[] = {ViewKind::kMap,   ViewKind::kSubmap, ViewKind::kUpdate,
                                  ViewKind::kMatch, ViewKind::kSearch, ViewKind::kGraph,
                                  ViewKind::kTime,  ViewKind::kChart};

const Recording& SmallLoop() {
  static const Recording recording = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  return recording;
}

ViewRequest RequestFor(ViewKind view) {
  ViewRequest request;
  request.view = view;
  return request;
}

std::vector<std::string> TextsOf(const Props& props) {
  std::vector<std::string> texts;
  for (const auto& prop : props) {
    if (auto* const text = vtkTextActor::SafeDownCast(prop)) texts.push_back(text->GetInput());
  }
  return texts;
}

std::size_t NumProps(const Scene& scene) {
  std::size_t count = 0;
  for (const Panel& panel : scene.panels) count += panel.props.size();
  return count;
}

std::string WhyRefused(const ViewRequest& request) {
  return MessageOf([&] { BuildScene(SmallLoop(), request); });
}

TEST(BuildSceneTest, EveryViewFillsItsPanelsAtAnySizeAndAnyStep) {
  for (const ViewKind view : kAllViews) {
    for (const auto& [width, height] : {std::pair{200, 150}, {320, 240}, {3840, 2160}}) {
      for (const int step : {130, 215}) {
        ViewRequest request = RequestFor(view);
        request.width = width;
        request.height = height;
        request.step = step;
        const Scene scene = BuildScene(SmallLoop(), request);
        EXPECT_EQ(scene.width, width);
        EXPECT_EQ(scene.height, height);
        EXPECT_GE(scene.panels.size(), 1u);
        EXPECT_GE(NumProps(scene), scene.panels.size()) << ToString(view);
      }
    }
  }
}

TEST(BuildSceneTest, AlreadyTheFirstScanHasAMapASubmapAnUpdateAndAGraph) {
  for (const ViewKind view :
       {ViewKind::kMap, ViewKind::kSubmap, ViewKind::kUpdate, ViewKind::kGraph, ViewKind::kTime}) {
    ViewRequest request = RequestFor(view);
    request.step = 0;
    EXPECT_GT(NumProps(BuildScene(SmallLoop(), request)), 0u) << ToString(view);
  }
}

TEST(BuildSceneTest, DrawsTheLayersAskedForAndNoOthers) {
  ViewRequest request = RequestFor(ViewKind::kMap);
  request.layers = std::set<LayerKind>{};
  EXPECT_EQ(NumProps(BuildScene(SmallLoop(), request)), 0u);
  request.layers = std::set<LayerKind>{LayerKind::kGrid, LayerKind::kFrames};
  EXPECT_EQ(NumProps(BuildScene(SmallLoop(), request)), 2u);
}

TEST(BuildSceneTest, DrawsRefusedLoopsAndCovariancesOnRequest) {
  ViewRequest request = RequestFor(ViewKind::kGraph);
  request.layers = std::set<LayerKind>{LayerKind::kRefused, LayerKind::kCovariances};
  EXPECT_EQ(NumProps(BuildScene(SmallLoop(), request)), 2u);
}

TEST(BuildSceneTest, TheRequestMayAimTheMainCamera) {
  ViewRequest request = RequestFor(ViewKind::kUpdate);
  request.center = Eigen::Vector2d(1.5, -2.0);
  request.width_in_meters = 3.0;
  const Scene scene = BuildScene(SmallLoop(), request);
  EXPECT_EQ(scene.panels[0].camera.center, Eigen::Vector2d(1.5, -2.0));
  EXPECT_NEAR(scene.panels[0].camera.meters_per_pixel * scene.panels[0].frame.width, 3.0, 1e-9);
}

TEST(BuildSceneTest, OnlyTheViewTimeLooksFromTheSideAskedFor) {
  ViewRequest request = RequestFor(ViewKind::kTime);
  request.azimuth = 90.0;
  request.elevation = 0.0;
  const Scene scene = BuildScene(SmallLoop(), request);
  ASSERT_TRUE(scene.panels.front().side.has_value());
  EXPECT_DOUBLE_EQ(scene.panels.front().side->azimuth, 0.5 * M_PI);
  EXPECT_DOUBLE_EQ(scene.panels.front().side->elevation, 0.0);
  EXPECT_FALSE(scene.panels.front().is_map);
  request.elevation = 90.5;
  EXPECT_EQ(WhyRefused(request), "elevation 90.500000 degrees: expected 0 to 90");
  request.view = ViewKind::kMap;
  EXPECT_EQ(WhyRefused(request),
            "view map is seen from above: expected azimuth and elevation for time");
  EXPECT_FALSE(BuildScene(SmallLoop(), RequestFor(ViewKind::kGraph)).panels[0].side.has_value());
}

TEST(ViewRequestTest, IsAnotherFromAnotherSideOrWithAnotherChart) {
  ViewRequest request;
  request.azimuth = 10.0;
  EXPECT_FALSE(request == ViewRequest());
  request = ViewRequest();
  request.elevation = 10.0;
  EXPECT_FALSE(request == ViewRequest());
  request = ViewRequest();
  request.chart = ChartKind::kCosts;
  EXPECT_FALSE(request == ViewRequest());
  EXPECT_TRUE(ViewRequest() == ViewRequest());
}

TEST(BuildSceneTest, AChartHasNoMapToAimAt) {
  ViewRequest request = RequestFor(ViewKind::kChart);
  request.width_in_meters = 3.0;
  EXPECT_EQ(WhyRefused(request), "view chart has no map: expected no center and no size of it");
}

TEST(BuildSceneTest, GivesTheLayersTheOpacitiesAskedFor) {
  ViewRequest request = RequestFor(ViewKind::kMap);
  request.layers = std::set<LayerKind>{LayerKind::kGrid, LayerKind::kFrames};
  request.opacities = {{LayerKind::kGrid, 0.4}, {LayerKind::kNodes, 0.1}};
  const Scene scene = BuildScene(SmallLoop(), request);
  ASSERT_EQ(scene.panels[0].props.size(), 2u);
  const auto opacity = [&](int i) {
    return vtkActor::SafeDownCast(scene.panels[0].props[i].prop)->GetProperty()->GetOpacity();
  };
  EXPECT_EQ(scene.panels[0].props[0].kind, LayerKind::kGrid);
  EXPECT_DOUBLE_EQ(opacity(0), 0.4);
  EXPECT_EQ(scene.panels[0].props[1].kind, LayerKind::kFrames);
  EXPECT_DOUBLE_EQ(opacity(1), 1.0);
}

TEST(BuildSceneTest, OnlyMapsAreInMetersAndHaveAScaleBarThatFollowsTheCamera) {
  const Scene scene = BuildScene(SmallLoop(), RequestFor(ViewKind::kSearch));
  const Panel& map = scene.panels.front();
  const Panel& chart = scene.panels.back();
  EXPECT_TRUE(map.is_map);
  EXPECT_FALSE(chart.is_map);
  FlatCamera far = map.camera;
  far.meters_per_pixel = 1.0;
  EXPECT_THAT(TextsOf(map.edge(far)), Contains("100 m"));
  EXPECT_THAT(TextsOf(map.edge(map.camera)), Not(Contains("100 m")));
  EXPECT_EQ(TextsOf(chart.edge(far)), TextsOf(chart.edge(chart.camera)));
}

TEST(BuildSceneTest, OneHeightOfASearchHasAPanelBetweenMapAndAngles) {
  ViewRequest request = RequestFor(ViewKind::kSearch);
  const Scene all = BuildScene(SmallLoop(), request);
  request.search.height = 3;
  const Scene one = BuildScene(SmallLoop(), request);
  EXPECT_EQ(all.panels.size(), 5u);
  ASSERT_EQ(one.panels.size(), 3u);
  EXPECT_GT(one.panels[1].frame.height, all.panels[1].frame.height);
  EXPECT_LT(one.panels[2].frame.top(), one.panels[1].frame.bottom);
  EXPECT_FALSE(one.panels[2].is_map);
}

TEST(BuildSceneTest, ManyConstraintsHaveAThinnedStandInForTheMovingCamera) {
  using When = LayerProp::When;
  const auto count = [](const Scene& scene, LayerKind kind, When when) {
    const auto& props = scene.panels[0].props;
    return std::count_if(props.begin(), props.end(), [&](const LayerProp& layer) {
      return layer.kind == kind && layer.when == when;
    });
  };
  const Scene small = BuildScene(SmallLoop(), RequestFor(ViewKind::kGraph));
  EXPECT_EQ(count(small, LayerKind::kIntra, When::kAlways), 1);
  EXPECT_EQ(count(small, LayerKind::kIntra, When::kMoving), 0);
  const Scene large = BuildScene(LargeRun::Make(1800, 10), RequestFor(ViewKind::kGraph));
  EXPECT_EQ(count(large, LayerKind::kIntra, When::kAlways), 0);  // 3560 of them
  EXPECT_EQ(count(large, LayerKind::kIntra, When::kAtRest), 1);
  EXPECT_EQ(count(large, LayerKind::kIntra, When::kMoving), 1);
  EXPECT_GE(count(large, LayerKind::kInter, When::kAlways), 1);
  EXPECT_EQ(count(large, LayerKind::kInter, When::kAtRest), 0);
  EXPECT_EQ(count(large, LayerKind::kInter, When::kMoving), 0);
}

TEST(BuildSceneTest, ACacheChangesNoScene) {
  DerivedCache cache(SmallLoop());
  BuildScene(&cache, RequestFor(ViewKind::kGraph));
  const Scene cached = BuildScene(&cache, RequestFor(ViewKind::kMap));
  const Scene fresh = BuildScene(SmallLoop(), RequestFor(ViewKind::kMap));
  EXPECT_EQ(cached.panels[0].camera.center, fresh.panels[0].camera.center);
  EXPECT_EQ(cached.panels[0].camera.meters_per_pixel, fresh.panels[0].camera.meters_per_pixel);
  EXPECT_EQ(NumProps(cached), NumProps(fresh));
}

/// The texts of the match of a scan, had it begun there.
std::vector<std::string> TextsOfMatch(std::optional<MatchStart> start) {
  ScanLog log = SimulateSmallLoop().log;
  log.scans.resize(12);
  Recording recording(log, SmallLoopOptions());
  Slam slam(recording.log(), recording.options(), 1);
  for (int scan = 0; scan < 12; ++scan) {
    SlamUpdate update = slam.AddScan(scan);
    if (scan == 10) update.step.match_start = start;
    recording.Append(std::move(update));
  }
  ViewRequest request = RequestFor(ViewKind::kMatch);
  request.step = 10;
  return TextsOf(BuildScene(recording, request).annotation);
}

TEST(BuildSceneTest, TellsWhereAMatchBeganUnlessWherePredicted) {
  EXPECT_THAT(TextsOfMatch(MatchStart::kNone), Contains("nowhere: not matched"));
  EXPECT_THAT(TextsOfMatch(MatchStart::kVelocity), Contains("by the velocity"));
  EXPECT_THAT(TextsOfMatch(MatchStart::kRecovery), Contains("by a wide search"));
  EXPECT_THAT(TextsOfMatch(MatchStart::kAhead), Contains("nowhere: led by scans ahead"));
  EXPECT_THAT(TextsOfMatch(MatchStart::kMotions), Contains("nowhere: led by motions before"));
  for (const auto start : {std::optional<MatchStart>(), std::optional(MatchStart::kPrior)}) {
    EXPECT_THAT(TextsOfMatch(start), Not(Contains("match began")));
  }
  EXPECT_THAT(TextsOfMatch(MatchStart::kNone), Contains("match began"));
}

TEST(BuildSceneTest, AGraphTellsOfItsOutliersAndItsWorstLoop) {
  const auto texts_with_outliers_beyond = [](double max_distance) {
    Options options = SmallLoopOptions();
    options.pose_graph.optimization_problem.outliers.max_distance = max_distance;
    return TextsOf(
        BuildScene(MapLog(SimulateSmallLoop().log, options), RequestFor(ViewKind::kGraph))
            .annotation);
  };
  const std::vector<std::string> with = texts_with_outliers_beyond(0.005);
  EXPECT_THAT(with, Contains("INTER, left out as outlier"));
  EXPECT_THAT(with, Contains("outliers"));
  const auto worst = std::find(with.begin(), with.end(), "worst residual");
  ASSERT_NE(worst, with.end());
  EXPECT_LE(std::stod(*std::next(worst)), 0.5) << "[cm] of those in force";
  const std::vector<std::string> without = texts_with_outliers_beyond(1.0);
  EXPECT_THAT(without, Not(Contains("INTER, left out as outlier")));
  EXPECT_THAT(without, Not(Contains("outliers")));
}

TEST(BuildSceneTest, RefusesWhatCannotBeDrawnSayingWhatWasExpected) {
  ViewRequest request = RequestFor(ViewKind::kMap);
  request.layers = std::set<LayerKind>{LayerKind::kTree};
  EXPECT_EQ(WhyRefused(request),
            "view map has no layer 'tree': expected some of grid, trajectory, nodes, frames, "
            "robot, selection, labels");
  request = RequestFor(ViewKind::kMap);
  request.opacities = {{LayerKind::kTree, 0.5}};
  EXPECT_THAT(WhyRefused(request), StartsWith("view map has no layer 'tree': expected some of"));
  request.opacities = {{LayerKind::kGrid, 1.5}};
  EXPECT_EQ(WhyRefused(request), "opacity of layer 'grid' is 1.5: expected 0 to 1");
  request = RequestFor(ViewKind::kMap);
  request.width_in_meters = 0.0;
  EXPECT_EQ(WhyRefused(request),
            "width of the map is 0 m: expected more than 0, and at most 1e+06");
  request.width_in_meters = std::numeric_limits<double>::infinity();
  EXPECT_EQ(WhyRefused(request),
            "width of the map is inf m: expected more than 0, and at most 1e+06");
  request = RequestFor(ViewKind::kMap);
  request.center = Eigen::Vector2d(std::nan(""), 0.0);
  EXPECT_EQ(WhyRefused(request),
            "center of the map is nan, 0: expected two numbers of at most 1e+06 m");
  request.center = Eigen::Vector2d(0.0, -1e8);
  EXPECT_EQ(WhyRefused(request),
            "center of the map is 0, -1e+08: expected two numbers of at most 1e+06 m");
  request = RequestFor(ViewKind::kTime);
  request.azimuth = std::nan("");
  EXPECT_EQ(WhyRefused(request), "azimuth: expected a finite number of degrees");
  request = RequestFor(ViewKind::kMatch);
  request.step = 0;
  EXPECT_EQ(WhyRefused(request),
            "the scan of step 0 was not matched: expected one after the first insertion with "
            "returns in range");
  request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{0};
  request.submap = SubmapId{0};
  EXPECT_EQ(WhyRefused(request),
            "node 0 cannot be searched in submap 0: expected a finished submap that it is not "
            "part of");
  request = RequestFor(ViewKind::kMap);
  request.search.height = 2;
  EXPECT_EQ(WhyRefused(request), "view map has no visits, heights or angles: expected view search");
  request = RequestFor(ViewKind::kSearch);
  request.search.height = 99;
  EXPECT_EQ(WhyRefused(request), "height 99 of the search: expected 0 to 3");
  request = RequestFor(ViewKind::kSearch);
  request.node = NodeId{0};
  request.step = 3;
  EXPECT_EQ(WhyRefused(request),
            "no loop search of node 0 until step 3: expected both a node and a submap");
}

}  // namespace
}  // namespace loopscope
