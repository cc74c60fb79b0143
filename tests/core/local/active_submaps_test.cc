// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/local/active_submaps.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "core/grid/ray_cast.h"
#include "tests/support/ascii_grid.h"
#include "tests/support/pose_matchers.h"

namespace loopscope {
namespace {

constexpr int kNumRangeData = 3;
constexpr double kResolution = 0.05;

SubmapsOptions Options() {
  SubmapsOptions options;
  options.num_range_data = kNumRangeData;
  options.grid_resolution = kResolution;
  return options;
}

/// What the robot sees: two points ahead of it.
RangeData SeenAhead() { return {{0.0, 0.0}, {{1.0, 0.3}, {1.0, -0.3}}, {}}; }

/// Where the robot is at node `index`: it goes a curve, on no lattice.
Pose2 PoseOfNode(int index) { return Pose2(0.1234 * index, -0.0777 * index, 0.21 * index); }

std::vector<ActiveSubmaps::Insertion> InsertNodes(int num_nodes, ActiveSubmaps* submaps) {
  std::vector<ActiveSubmaps::Insertion> insertions;
  for (int i = 0; i < num_nodes; ++i) {
    insertions.push_back(submaps->Insert(PoseOfNode(i), SeenAhead()));
  }
  return insertions;
}

TEST(ActiveSubmaps, HasNothingToMatchBeforeTheFirstInsertion) {
  ActiveSubmaps submaps(Options());
  EXPECT_EQ(submaps.MatchingSubmap(), nullptr);
  submaps.Insert(Pose2(), SeenAhead());
  EXPECT_EQ(submaps.MatchingSubmap()->id, SubmapId{0});
}

TEST(ActiveSubmaps, BeginsASubmapEveryNumRangeDataNodesAndFinishesItAfterTwice) {
  //                          node  0  1  2  3  4  5  6  7  8  9 10 11
  const std::vector<int> first = {0, 0, 0, 0, 0, 0, 1, 1, 1, 2, 2, 2};
  const std::vector<int> number = {1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2};
  const std::vector<int> started = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  const std::vector<int> ended = {0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 0, 1};
  ActiveSubmaps submaps(Options());
  const auto insertions = InsertNodes(static_cast<int>(first.size()), &submaps);
  for (std::size_t i = 0; i < first.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(insertions[i].first_submap, SubmapId{first[i]});
    EXPECT_EQ(insertions[i].num_submaps, number[i]);
    EXPECT_EQ(insertions[i].started_local_from_submap.has_value(), started[i] == 1);
    ASSERT_EQ(insertions[i].finished.has_value(), ended[i] == 1);
    if (!insertions[i].finished) continue;
    EXPECT_EQ(insertions[i].finished->id, insertions[i].first_submap);
    EXPECT_EQ(insertions[i].finished->num_nodes, 2 * kNumRangeData);
  }
}

TEST(ActiveSubmaps, MatchesAgainstTheOlderOfThem) {
  ActiveSubmaps submaps(Options());
  for (int i = 0; i < 4 * kNumRangeData; ++i) {
    submaps.Insert(PoseOfNode(i), SeenAhead());
    const int num_finished = std::max(0, (i + 1) / kNumRangeData - 1);
    EXPECT_EQ(submaps.MatchingSubmap()->id, SubmapId{num_finished}) << i;
  }
}

TEST(ActiveSubmaps, PlacesASubmapOnTheLatticePointNearestToTheRobot) {
  ActiveSubmaps submaps(Options());
  for (const auto& insertion : InsertNodes(9, &submaps)) {
    if (!insertion.started_local_from_submap) continue;
    const Pose2& local_from_submap = *insertion.started_local_from_submap;
    EXPECT_EQ(local_from_submap.rotation, 0.0);
    const Eigen::Vector2d cells = local_from_submap.translation / kResolution;
    EXPECT_NEAR(cells.x(), std::round(cells.x()), 1e-9);
    EXPECT_NEAR(cells.y(), std::round(cells.y()), 1e-9);
  }
  const Pose2 robot(0.12, -0.18, 1.0);
  EXPECT_THAT(*ActiveSubmaps(Options()).Insert(robot, SeenAhead()).started_local_from_submap,
              PoseNear(Pose2(0.10, -0.20, 0.0), 1e-12, 0.0));
}

/// What a cell of the local frame holds in a submap.
CellValue ValueInLocal(const ActiveSubmap& submap, CellIndex cell_in_local) {
  const CellIndex origin = CellOf(submap.local_from_submap.translation, kResolution);
  return submap.grid.value({cell_in_local.x - origin.x, cell_in_local.y - origin.y});
}

TEST(ActiveSubmaps, BothHoldTheScansThatTheyShareAtTheSamePlace) {
  ActiveSubmaps submaps(Options());
  std::vector<ActiveSubmap> finished;
  std::vector<CellIndex> shared;  // cells that only the scans in both submaps see
  for (int i = 0; i < 3 * kNumRangeData; ++i) {
    // Each third of the nodes stands far from the others.
    const Pose2 pose(10.0 * (i / kNumRangeData) + 0.013 * i, 0.0, 0.0);
    auto insertion = submaps.Insert(pose, SeenAhead());
    if (i / kNumRangeData == 1) {
      const ScanCells cells = CastRays(Transform(pose, SeenAhead()), kResolution);
      shared.insert(shared.end(), cells.hits.begin(), cells.hits.end());
      shared.insert(shared.end(), cells.misses.begin(), cells.misses.end());
    }
    if (insertion.finished) finished.push_back(std::move(*insertion.finished));
  }
  ASSERT_EQ(finished.size(), 2u);
  ASSERT_NE(finished[0].local_from_submap, finished[1].local_from_submap);
  for (const CellIndex cell : shared) {
    EXPECT_NE(ValueInLocal(finished[0], cell), kUnknown);
    EXPECT_EQ(ValueInLocal(finished[0], cell), ValueInLocal(finished[1], cell));
  }
}

TEST(ToSubmapLattice, NamesTheSameCellsFromTheSubmapsOrigin) {
  const ScanCells in_local{{{3, 4}}, {{0, 0}, {-2, 7}}, {{-2, 0}, 6, 8}};
  const ScanCells in_submap = ToSubmapLattice(in_local, Pose2(0.10, -0.15, 0.0), kResolution);
  EXPECT_EQ(in_submap.hits, (std::vector<CellIndex>{{1, 7}}));
  EXPECT_EQ(in_submap.misses, (std::vector<CellIndex>{{-2, 3}, {-4, 10}}));
  EXPECT_EQ(in_submap.box.min, (CellIndex{-4, 3}));
  EXPECT_EQ(in_submap.box.width, 6);
  EXPECT_EQ(in_submap.box.height, 8);
}

TEST(ToSubmapLattice, GivesTheCellsThatTheScanHitsInTheFrameOfTheSubmap) {
  const Pose2 local_from_submap(0.35, -1.20, 0.0);
  for (int i = 0; i < 20; ++i) {
    const RangeData in_local = Transform(PoseOfNode(i), SeenAhead());
    const RangeData in_submap = Transform(local_from_submap.Inverse(), in_local);
    const ScanCells shifted =
        ToSubmapLattice(CastRays(in_local, kResolution), local_from_submap, kResolution);
    EXPECT_EQ(shifted.hits, CastRays(in_submap, kResolution).hits) << i;
  }
}

}  // namespace
}  // namespace loopscope
