// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/occupancy_map.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// Nodes at these poses, each of which saw a wall `range` ahead, and nothing else.
Recording NodesBeforeAWall(const std::vector<Pose2>& global_from_nodes,
                           const std::vector<float>& ranges) {
  ScanLog log;
  log.beam_geometries = {{3, -M_PI / 2.0, M_PI / 2.0}};
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    log.scans.push_back({static_cast<double>(i), 0, {kNothing, ranges[i], kNothing}, 0});
  }
  Options options;
  options.trajectory_builder_2d.submaps.grid_resolution = 0.1;
  Recording recording(log, options);
  for (int i = 0; i < static_cast<int>(ranges.size()); ++i) {
    SlamUpdate update;
    update.step.outcome = StepOutcome::kInserted;
    update.step.node = NodeId{i};
    if (i == 0) update.started_submap = Submap{Pose2(), NodeId{0}, 0, -1};
    update.node = Node{i, Pose2(), SubmapId{0}, 1};
    if (i + 1 == static_cast<int>(ranges.size())) {
      Optimization optimization;
      optimization.step = i;
      optimization.global_from_submap = {Pose2()};
      optimization.global_from_node = global_from_nodes;
      update.optimization = optimization;
    }
    recording.Append(update);
  }
  return recording;
}

/// '#' occupied, '.' free, ' ' unknown, row by row from the top, without what is unknown all
/// around.
std::string Draw(const OccupancyMap& map) {
  CellBox known;
  for (int y = map.box.min.y; y < map.box.min.y + map.box.height; ++y) {
    for (int x = map.box.min.x; x < map.box.min.x + map.box.width; ++x) {
      if (!std::isnan(map.probability({x, y}))) known = Union(known, {{x, y}, 1, 1});
    }
  }
  std::string drawing;
  for (int y = known.min.y + known.height - 1; y >= known.min.y; --y) {
    for (int x = known.min.x; x < known.min.x + known.width; ++x) {
      const float probability = map.probability({x, y});
      drawing += std::isnan(probability) ? ' ' : probability > 0.5f ? '#' : '.';
    }
    drawing += '\n';
  }
  return drawing;
}

OccupancyMap MapOf(const Recording& recording) {
  return BuildOccupancyMap(recording, StateAfterStep(recording, recording.num_steps() - 1));
}

TEST(OccupancyMap, ShowsRaysFromTheOptimizedPoses) {
  const OccupancyMap map =
      MapOf(NodesBeforeAWall({Pose2(0.0, 0.0, 0.0), Pose2(0.0, 0.0, M_PI / 2.0)}, {0.5f, 0.3f}));
  EXPECT_EQ(Draw(map),
            "#     \n"
            ".     \n"
            ".     \n"
            ".....#\n");
  EXPECT_GT(map.probability({5, 0}), 0.5f);
  EXPECT_GT(map.probability({0, 3}), 0.5f);
}

TEST(OccupancyMap, MultipliesTheOddsOfAllObservations) {
  const auto with_hits = [](int num_hits) {
    std::vector<float> ranges(num_hits, 0.5f);
    return MapOf(NodesBeforeAWall(std::vector<Pose2>(num_hits), ranges));
  };
  EXPECT_NEAR(with_hits(1).probability({5, 0}), 0.7, 1e-6);
  EXPECT_NEAR(with_hits(1).probability({2, 0}), 0.4, 1e-6);
  const double odds = std::pow(0.7 / 0.3, 3);
  EXPECT_NEAR(with_hits(3).probability({5, 0}), odds / (1.0 + odds), 1e-6);
  const OccupancyMap passed = MapOf(NodesBeforeAWall({Pose2(), Pose2()}, {0.5f, 0.9f}));
  const double mixed_odds = (0.7 / 0.3) * (0.4 / 0.6);
  EXPECT_NEAR(passed.probability({5, 0}), mixed_odds / (1.0 + mixed_odds), 1e-6);
}

TEST(OccupancyMap, OfScansWithoutReturnsHasNoKnownCell) {
  EXPECT_EQ(Draw(MapOf(NodesBeforeAWall({Pose2()}, {kNothing}))), "");
}

TEST(OccupancyMap, ThatFitsInNoMemoryThrows) {
  const Recording recording = NodesBeforeAWall({Pose2(), Pose2(1e7, 1e7, 0.0)}, {0.5f, 0.5f});
  EXPECT_THROW(MapOf(recording), std::length_error);
  EXPECT_THROW(MapOf(NodesBeforeAWall({Pose2(), Pose2(1e300, 0.0, 0.0)}, {0.5f, 0.5f})),
               std::length_error);
}

}  // namespace
}  // namespace loopscope
