// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/layers/constraints.h"

#include <gtest/gtest.h>

#include "tests/render/layers/layer_data.h"

namespace loopscope {
namespace {

using Tag = Constraint::Tag;

/// Submap 0 stands at (1, 0) and looks along y; node 0 stands at (1, 3), node 1 at (4, 4).
MapState SmallState() {
  MapState state;
  state.num_submaps = 1;
  state.num_nodes = 2;
  state.global_from_submap = {Pose2(1.0, 0.0, DegreesToRadians(90.0))};
  state.global_from_node = {Pose2(1.0, 3.0, 0.0), Pose2(4.0, 4.0, 0.0)};
  return state;
}

/// Node 0 two metres ahead of the submap, so a metre short of where it is; node 1 found elsewhere.
std::vector<Constraint> SmallConstraints() {
  return {{SubmapId{0}, NodeId{0}, Pose2(2.0, 0.0, 0.0), 1.0, 1.0, Tag::kIntraSubmap},
          {SubmapId{0}, NodeId{1}, Pose2(4.0, 0.0, 0.0), 1.0, 1.0, Tag::kInterSubmap},
          {SubmapId{0}, NodeId{7}, Pose2(4.0, 0.0, 0.0), 1.0, 1.0, Tag::kInterSubmap}};
}

TEST(PlaceConstraintsTest, ExpectsTheNodeWhereTheSubmapSawIt) {
  const auto placed = PlaceConstraints(SmallConstraints(), Tag::kIntraSubmap, SmallState());
  ASSERT_EQ(placed.size(), 1u);
  EXPECT_TRUE(placed[0].expected_node.isApprox(Eigen::Vector2d(1.0, 2.0)));
  EXPECT_TRUE(placed[0].node.isApprox(Eigen::Vector2d(1.0, 3.0)));
  EXPECT_NEAR(placed[0].residual(), 1.0, 1e-12);
}

TEST(PlaceConstraintsTest, LeavesOutWhatDoesNotExistYet) {
  EXPECT_EQ(PlaceConstraints(SmallConstraints(), Tag::kInterSubmap, SmallState()).size(), 1u);
}

TEST(ThinnedTest, TakesEveryKthAndNoMoreThanAllowed) {
  std::vector<PlacedConstraint> constraints(10);
  for (int i = 0; i < 10; ++i) constraints[i].constraint.node = NodeId{i};
  const auto nodes_of = [&](int max_count) {
    std::vector<int> nodes;
    for (const auto& placed : Thinned(constraints, max_count)) {
      nodes.push_back(placed.constraint.node.index);
    }
    return nodes;
  };
  EXPECT_EQ(nodes_of(4), (std::vector<int>{0, 3, 6, 9}));
  EXPECT_EQ(nodes_of(3), (std::vector<int>{0, 4, 8}));
  EXPECT_EQ(nodes_of(10).size(), 10u);
  EXPECT_EQ(nodes_of(100).size(), 10u);
  EXPECT_TRUE(Thinned({}, 3).empty());
}

TEST(ConstraintLayersTest, AConstraintEndsAtTheExpectedPlaceAndTheResidualGoesOnToTheNode) {
  const auto placed = PlaceConstraints(SmallConstraints(), Tag::kInterSubmap, SmallState());
  const auto constraints = InterConstraintsLayer(placed, Color{1, 1, 1}, 1.0);
  const auto residuals = ResidualsLayer(placed, Color{2, 2, 2}, 1.0);
  EXPECT_EQ(PointOf(constraints, 0), Eigen::Vector2d(1.0, 0.0));
  EXPECT_EQ(PointOf(constraints, 1), Eigen::Vector2d(1.0, 4.0));
  EXPECT_EQ(PointOf(residuals, 0), PointOf(constraints, 1));
  EXPECT_EQ(PointOf(residuals, 1), Eigen::Vector2d(4.0, 4.0));
  EXPECT_EQ(ColorOf(residuals, 1), (Color{2, 2, 2}));
}

TEST(ConstraintLayersTest, IntraConstraintsHaveTheColorOfTheirSubmap) {
  auto placed = PlaceConstraints(SmallConstraints(), Tag::kIntraSubmap, SmallState());
  placed.push_back(placed[0]);
  placed[1].constraint.submap = SubmapId{1};
  const auto layer = IntraConstraintsLayer(placed, 1.0, 1.0);
  EXPECT_EQ(ColorOf(layer, 0), HueOf(0));
  EXPECT_EQ(ColorOf(layer, 2), HueOf(1));
}

}  // namespace
}  // namespace loopscope
