// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view.h"

#include <gtest/gtest.h>

#include "tests/support/mapped_log.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

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
    for (const auto& [width, height] : {std::pair{320, 240}, {3840, 2160}}) {
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
  request.elevation = 90.5;
  EXPECT_EQ(WhyRefused(request), "elevation 90.500000 degrees: expected 0 to 90");
  request.view = ViewKind::kMap;
  EXPECT_EQ(WhyRefused(request),
            "view map is seen from above: expected azimuth and elevation for time");
  EXPECT_FALSE(BuildScene(SmallLoop(), RequestFor(ViewKind::kGraph)).panels[0].side.has_value());
}

TEST(BuildSceneTest, AChartHasNoMapToAimAt) {
  ViewRequest request = RequestFor(ViewKind::kChart);
  request.width_in_meters = 3.0;
  EXPECT_EQ(WhyRefused(request), "view chart has no map: expected no center and no width of it");
}

TEST(BuildSceneTest, ACacheChangesNoScene) {
  GridCache cache(SmallLoop());
  BuildScene(&cache, RequestFor(ViewKind::kGraph));
  const Scene cached = BuildScene(&cache, RequestFor(ViewKind::kMap));
  const Scene fresh = BuildScene(SmallLoop(), RequestFor(ViewKind::kMap));
  EXPECT_EQ(cached.panels[0].camera.center, fresh.panels[0].camera.center);
  EXPECT_EQ(cached.panels[0].camera.meters_per_pixel, fresh.panels[0].camera.meters_per_pixel);
  EXPECT_EQ(NumProps(cached), NumProps(fresh));
}

TEST(BuildSceneTest, RefusesWhatCannotBeDrawnSayingWhatWasExpected) {
  ViewRequest request = RequestFor(ViewKind::kMap);
  request.layers = std::set<LayerKind>{LayerKind::kTree};
  EXPECT_EQ(WhyRefused(request),
            "view map has no layer 'tree': expected some of grid, trajectory, nodes, frames, "
            "robot, labels");
  request = RequestFor(ViewKind::kMap);
  request.width_in_meters = 0.0;
  EXPECT_EQ(WhyRefused(request), "width of the map is 0.000000 m: expected more than 0");
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
  request.step = 3;
  request.submap.reset();
  EXPECT_EQ(WhyRefused(request),
            "no loop search of node 0 until step 3: expected both a node and a submap");
}

}  // namespace
}  // namespace loopscope
