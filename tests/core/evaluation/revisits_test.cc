// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/evaluation/revisits.h"

#include <gtest/gtest.h>

#include "tests/support/line_run.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

constexpr RevisitOptions kSamePlace{0.5, 5.0, 0.5};

Pairs SubmapsOf(const std::vector<Revisit>& revisits) {
  Pairs pairs;
  for (const Revisit& revisit : revisits) {
    pairs.emplace_back(revisit.first.index, revisit.second.index);
  }
  return pairs;
}

std::vector<Revisit> RevisitsOfLine(const Trajectory& reference, const RevisitOptions& options) {
  const Recording recording = LineRun({});
  return RevisitsOf(recording, ReferencePosesOfNodes(recording, reference), options);
}

TEST(Revisits, ArePairsOfSubmapsOfTheSamePlace) {
  const auto revisits = RevisitsOfLine(LineReference(), kSamePlace);
  ASSERT_EQ(SubmapsOf(revisits), (Pairs{{0, 5}, {1, 4}, {2, 3}}));
  EXPECT_NEAR(revisits[1].distance, 0.0, 1e-9);
  EXPECT_EQ(revisits[1].second_node.index, 23 - revisits[1].first_node.index);
}

TEST(Revisits, AreFoundInTheCoordinatesOfACountry) {
  Trajectory reference = LineReference();
  for (TimedPose& pose : reference) pose.map_from_base = Pose2(5e6, 5e9, 0.0) * pose.map_from_base;
  EXPECT_EQ(SubmapsOf(RevisitsOfLine(reference, kSamePlace)), (Pairs{{0, 5}, {1, 4}, {2, 3}}));
}

TEST(Revisits, AreNoneWhereTheReferenceIsNowhere) {
  Trajectory reference = LineReference();
  for (int i = 12; i < 24; ++i) reference[i].map_from_base = Pose2(1e15, 0.0, 0.0);
  EXPECT_TRUE(RevisitsOfLine(reference, kSamePlace).empty());
}

TEST(Revisits, NeedAWayInBetween) {
  // From node 8 to node 15 the robot goes 3 m there and 3 m back.
  EXPECT_EQ(SubmapsOf(RevisitsOfLine(LineReference(), {0.5, 6.5, 0.5})), (Pairs{{0, 5}, {1, 4}}));
}

TEST(Revisits, MayBeSomeMetersApart) {
  const auto revisits = RevisitsOfLine(LineReference(), {1.5, 14.5, 0.0});
  // Nodes 0 ... 3 and 20 ... 23, and 4 to 20 and 3 to 19.
  EXPECT_EQ(SubmapsOf(revisits), (Pairs{{0, 4}, {0, 5}, {1, 5}}));
}

TEST(Revisits, AreNotBehindAWall) {
  // The way back is through another corridor beside the first one.
  Trajectory reference = LineReference();
  for (int i = 12; i < 24; ++i) {
    reference[i].map_from_base = reference[i].map_from_base * Pose2(0.0, 2.9, 0.0);
  }
  EXPECT_TRUE(RevisitsOfLine(reference, {3.0, 5.0, 0.5}).empty());
  EXPECT_FALSE(RevisitsOfLine(reference, {3.0, 5.0, 0.0}).empty());
}

TEST(Revisits, AreFoundByALoopFromEitherSubmapToANodeOfTheOther) {
  const auto missed_with = [&](const std::vector<LoopCandidate>& loops) {
    const Recording recording = LineRun(loops);
    const auto reference = ReferencePosesOfNodes(recording, LineReference());
    return SubmapsOf(
        RevisitsWithout(recording, JudgeLoops(recording, StateAfterStep(recording, 23), reference),
                        RevisitsOf(recording, reference, kSamePlace)));
  };
  EXPECT_EQ(missed_with({}), (Pairs{{0, 5}, {1, 4}, {2, 3}}));
  EXPECT_EQ(missed_with({LineLoop(0, 22, {})}), (Pairs{{1, 4}, {2, 3}}));
  EXPECT_EQ(missed_with({LineLoop(3, 9, {})}), (Pairs{{0, 5}, {1, 4}}));
  EXPECT_EQ(missed_with({LineLoop(0, 18, {})}).size(), 3u);  // to another submap
}

TEST(Revisits, OfASimulatedRunAreThoseOfABruteSearch) {
  const Recording& recording = SmallLoopRun();
  const auto reference = ReferencePosesOfNodes(recording, SimulateSmallLoop().ground_truth);
  Pairs expected;
  const int num_submaps = static_cast<int>(recording.submaps().size());
  std::vector<double> ways(recording.nodes().size(), 0.0);
  for (std::size_t i = 1; i < ways.size(); ++i) {
    ways[i] = ways[i - 1] + (recording.nodes()[i].local_from_base.translation -
                             recording.nodes()[i - 1].local_from_base.translation)
                                .norm();
  }
  const auto is_revisit = [&](const Submap& a, const Submap& b) {
    for (int i = a.first_node.index; i < a.first_node.index + a.num_nodes; ++i) {
      for (int j = b.first_node.index; j < b.first_node.index + b.num_nodes; ++j) {
        const double distance = (reference[i]->translation - reference[j]->translation).norm();
        if (distance < 1.0 && ways[j] - ways[i] > 10.0) return true;
      }
    }
    return false;
  };
  for (int a = 0; a < num_submaps; ++a) {
    for (int b = a + 1; b < num_submaps; ++b) {
      if (recording.submaps()[a].finished_step < 0) continue;
      if (is_revisit(recording.submaps()[a], recording.submaps()[b])) expected.emplace_back(a, b);
    }
  }
  EXPECT_GT(expected.size(), 5u);
  EXPECT_EQ(SubmapsOf(RevisitsOf(recording, reference, {1.0, 10.0, 0.0})), expected);
}

}  // namespace
}  // namespace loopscope
