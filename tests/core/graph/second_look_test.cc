// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/second_look.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace loopscope {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

/// Two submaps of ten nodes each, a metre apart: the robot goes 9 m ahead, far away, and comes back
/// on the same way, as far as the pose graph knows.
class SecondLookTest : public ::testing::Test {
 protected:
  SecondLookTest() {
    const Eigen::AlignedBox2d box(Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(9.0, 0.0));
    submaps_ = {{SubmapId{0}, Pose2(), box, NodeId{0}, 10, &seen_},
                {SubmapId{5}, Pose2(), box, NodeId{10}, 10, &seen_}};
    for (int i = 0; i < 20; ++i) {
      global_from_node_.emplace_back(i % 10, 0.0, 0.0);
      node_ways_.push_back(i < 10 ? i : 90.0 + i);
    }
    options_.num_nodes = 2;
  }

  /// Moves the second submap to the left.
  void Move(double distance) {
    submaps_[1].global_from_submap = Pose2(0.0, distance, 0.0);
    for (int i = 10; i < 20; ++i) global_from_node_[i] = Pose2(i - 10, distance, 0.0);
  }

  std::vector<SecondLook::Pair> Choose(SecondLook* look) const {
    return look->Choose(submaps_, global_from_node_, node_ways_);
  }

  /// Each sees the first 4 m of the way.
  static ProbabilityGrid SeenGrid() {
    ProbabilityGrid grid(0.05);
    std::vector<CellIndex> cells;
    for (int x = 0; x <= 80; ++x) cells.push_back({x, 0});
    grid.GrowToInclude(BoxOf(cells));
    grid.Update(cells, OddsUpdate(0.4));
    return grid;
  }

  const SeenArea seen_{SeenGrid()};
  SecondLookOptions options_;
  std::vector<SubmapPlace> submaps_;
  std::vector<Pose2> global_from_node_;
  std::vector<double> node_ways_;
};

SecondLook::Pair PairOf(int submap, int node) { return {SubmapId{submap}, NodeId{node}}; }

TEST_F(SecondLookTest, TakesAFewNodesOfEachInTheOther) {
  SecondLook look(options_);
  EXPECT_THAT(Choose(&look), ElementsAre(PairOf(0, 12), PairOf(0, 17), PairOf(5, 2), PairOf(5, 7)));
}

TEST_F(SecondLookTest, TakesNoNodesInASubmapThatIsNotFinished) {
  submaps_[1].seen = nullptr;
  EXPECT_THAT(SecondLook(options_).ChooseOfUntied(submaps_, global_from_node_, node_ways_, 2),
              ElementsAre(PairOf(0, 12), PairOf(0, 17)));
}

TEST_F(SecondLookTest, TakesOnlyNodesThatAreNear) {
  Move(2.0);
  for (int i = 11; i < 20; ++i) global_from_node_[i] = Pose2(0.0, 3.1, 0.0);
  for (int i = 0; i < 10; ++i) global_from_node_[i] = Pose2(0.0, -3.1, 0.0);
  SecondLook look(options_);
  EXPECT_THAT(Choose(&look), ElementsAre(PairOf(0, 10)));
}

TEST_F(SecondLookTest, TakesOnlyNodesAtPlacesThatTheSubmapHasSeen) {
  options_.max_unseen_distance = 0.3;
  options_.num_nodes = 10;
  SecondLook look(options_);
  EXPECT_THAT(Choose(&look),
              ElementsAre(PairOf(0, 10), PairOf(0, 11), PairOf(0, 12), PairOf(0, 13), PairOf(0, 14),
                          PairOf(5, 0), PairOf(5, 1), PairOf(5, 2), PairOf(5, 3), PairOf(5, 4)));
}

TEST_F(SecondLookTest, LeavesWhatALoopTies) {
  SecondLook look(options_);
  look.Tie(SubmapId{5}, SubmapId{0});
  EXPECT_THAT(Choose(&look), IsEmpty());
}

TEST_F(SecondLookTest, LeavesNeighboursOnTheWay) {
  for (int i = 10; i < 20; ++i) node_ways_[i] = 9.0 + options_.min_way - 10.0 + (i - 10);
  SecondLook look(options_);
  EXPECT_THAT(Choose(&look), IsEmpty());
}

TEST_F(SecondLookTest, LooksAgainOnlyOnceTheTwoHaveMoved) {
  SecondLook look(options_);
  EXPECT_FALSE(Choose(&look).empty());
  Move(1.9);
  EXPECT_THAT(Choose(&look), IsEmpty());
  Move(2.1);
  EXPECT_FALSE(Choose(&look).empty());
  Move(0.2);
  EXPECT_THAT(Choose(&look), IsEmpty()) << "it counts from the last look";
}

TEST_F(SecondLookTest, TakesAllUntiedPairsInTheEnd) {
  options_.num_nodes = 0;
  SecondLook look(options_);
  const auto choose = [&] {
    return look.ChooseOfUntied(submaps_, global_from_node_, node_ways_, 1);
  };
  EXPECT_THAT(choose(), ElementsAre(PairOf(0, 15), PairOf(5, 5)));
  EXPECT_THAT(choose(), ElementsAre(PairOf(0, 15), PairOf(5, 5))) << "moved or not";
  look.Tie(SubmapId{5}, SubmapId{0});
  EXPECT_THAT(choose(), IsEmpty());
}

TEST_F(SecondLookTest, TakesANodeThatLiesInTwoSubmapsOnce) {
  submaps_.push_back(submaps_[1]);
  submaps_[2].id = SubmapId{6};
  SecondLook look(options_);
  const auto untied = look.ChooseOfUntied(submaps_, global_from_node_, node_ways_, 1);
  EXPECT_THAT(untied, ElementsAre(PairOf(0, 15), PairOf(5, 5), PairOf(6, 5)));
  EXPECT_THAT(Choose(&look), ElementsAre(PairOf(0, 12), PairOf(0, 17), PairOf(5, 2), PairOf(5, 7),
                                         PairOf(6, 2), PairOf(6, 7)));
}

TEST_F(SecondLookTest, IsOffWithoutNodes) {
  options_.num_nodes = 0;
  SecondLook look(options_);
  EXPECT_THAT(Choose(&look), IsEmpty());
}

}  // namespace
}  // namespace loopscope
