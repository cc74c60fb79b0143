// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/time_layers.h"

#include <gmock/gmock.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

constexpr Color kRed{255, 0, 0};

double HeightOf(vtkActor* layer, vtkIdType point) { return DataOf(layer)->GetPoint(point)[2]; }

/// Three scans, ten seconds apart: two nodes 4 m apart, and a submap that begins with each.
Recording ThreeScans() {
  ScanLog log;
  for (const double time : {100.0, 110.0, 120.0}) {
    LaserScan scan;
    scan.time = time;
    log.scans.push_back(scan);
  }
  Recording recording(log, LoopscopePreset());
  for (const int node : {0, -1, 1}) {
    SlamUpdate update;
    if (node >= 0) {
      update.step.outcome = StepOutcome::kInserted;
      update.step.node = NodeId{node};
      update.started_submap = Submap{Pose2(), NodeId{node}, 0, -1};
      update.node = Node{2 * node, Pose2(4.0 * node, 1.0 * node, 0.0), SubmapId{node}, 1};
    }
    recording.Append(update);
  }
  return recording;
}

TEST(TimeScaleTest, TheWholeRunIsSoManyTimesAsHighAsItsNodesLieApart) {
  const TimeScale scale = TimeScaleOf(ThreeScans(), 0.5);
  EXPECT_DOUBLE_EQ(scale.HeightAt(100.0), 0.0);
  EXPECT_DOUBLE_EQ(scale.HeightAt(120.0), 2.0);
}

TEST(TimeScaleTest, NodesAreAsHighAsTheirScanAndSubmapsAsTheirFirstNode) {
  const Recording recording = ThreeScans();
  const TimeScale scale{100.0, 0.1};
  EXPECT_THAT(HeightsOfNodes(recording, scale, 2), ElementsAre(0.0, 2.0));
  EXPECT_THAT(HeightsOfNodes(recording, scale, 1), SizeIs(1));
  EXPECT_THAT(HeightsOfSubmaps(recording, scale, 2), ElementsAre(0.0, 2.0));
}

TEST(RisingLayersTest, PutEveryPoseAtItsHeight) {
  const std::vector<Pose2> poses{Pose2(1.0, 2.0, 0.0), Pose2(3.0, 4.0, 0.0)};
  const std::vector<double> heights{5.0, 6.0};
  const auto way = RisingTrajectoryLayer(poses, heights, kRed, 1.0);
  EXPECT_EQ(DataOf(way)->GetNumberOfLines(), 1);
  EXPECT_EQ(PointOf(way, 1), Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(HeightOf(way, 0), 5.0);
  EXPECT_EQ(HeightOf(way, 1), 6.0);
  const auto nodes = RisingNodesLayer(poses, heights, kRed, 3.0);
  EXPECT_EQ(PointOf(nodes, 1), Eigen::Vector2d(3.0, 4.0));
  EXPECT_EQ(HeightOf(nodes, 1), 6.0);
  const auto frames = RisingFramesLayer(poses, heights, 0.5, 1.0, PaletteOf(Theme::kDefault));
  EXPECT_EQ(DataOf(frames)->GetNumberOfLines(), 4);
  EXPECT_EQ(PointOf(frames, 1), Eigen::Vector2d(1.5, 2.0));
  EXPECT_EQ(HeightOf(frames, 7), 6.0);
}

TEST(RisingLayersTest, ConstraintsGoFromTheHeightOfTheSubmapToThatOfTheNode) {
  const PlacedConstraint constraint{
      {SubmapId{1}, NodeId{0}, Pose2(), 1.0, 1.0, Constraint::Tag::kInterSubmap},
      {1.0, 1.0},
      {1.9, 2.0},
      {2.0, 2.0}};
  const auto plain = RisingConstraintsLayer({constraint}, {3.0, 4.0}, {5.0}, kRed, 0.5, 1.0);
  EXPECT_EQ(PointOf(plain, 1), Eigen::Vector2d(2.0, 2.0));
  EXPECT_EQ(HeightOf(plain, 0), 4.0);
  EXPECT_EQ(HeightOf(plain, 1), 5.0);
  EXPECT_EQ(ColorOf(plain, 0), WithOpacity(kRed, 0.5));
  const auto by_submap =
      RisingConstraintsLayer({constraint}, {3.0, 4.0}, {5.0}, std::nullopt, 0.5, 1.0);
  EXPECT_EQ(ColorOf(by_submap, 0), WithOpacity(HueOf(1), 0.5));
}

TEST(TicksUpToTest, AreRoundAndNotTooMany) {
  EXPECT_THAT(TicksUpTo(100.0), ElementsAre(0.0, 20.0, 40.0, 60.0, 80.0, 100.0));
  EXPECT_THAT(TicksUpTo(0.45), ElementsAre(0.0, 0.1, 0.2, testing::DoubleEq(0.3), 0.4));
  EXPECT_THAT(TicksUpTo(0.0), ElementsAre(0.0));
  for (const double duration : {1.0, 7.0, 19.0, 333.0, 2689.0}) {
    EXPECT_LE(TicksUpTo(duration).size(), 11u) << duration;
  }
}

}  // namespace
}  // namespace loopscope
