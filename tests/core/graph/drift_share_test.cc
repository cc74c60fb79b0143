// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/drift_share.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

MeasuredDriftOptions Options() {
  MeasuredDriftOptions options;
  options.min_window_share = 0.2;
  return options;
}

/// `num` loops that took 0.1 of their linear windows and 0.15 of their angular ones.
std::vector<DriftShare> Loops(int num) { return std::vector<DriftShare>(num, {0.1, 0.15}); }

TEST(DriftShareOf, IsOfTheWayFromTheGuessToTheLoop) {
  LoopGate gate;
  gate.linear_window = 2.0;
  gate.angular_window = 0.4;
  const Pose2 guess(3.0, 1.0, 3.1);
  const DriftShare share = DriftShareOf(guess, guess * Pose2(0.3, -0.4, -0.1), gate);
  EXPECT_NEAR(share.linear, 0.25, 1e-12);
  EXPECT_NEAR(share.angular, 0.25, 1e-12);
}

TEST(DriftShareOf, IsAllOfAWindowThatIsNone) {
  const DriftShare share = DriftShareOf(Pose2(), Pose2(0.1, 0.0, 0.1), LoopGate());
  EXPECT_EQ(share.linear, 1.0);
  EXPECT_EQ(share.angular, 1.0);
  EXPECT_EQ(ShareOfWindow(0.0, 0.0), 1.0) << "as loops are explained";
  EXPECT_EQ(ShareOfWindow(0.5, 2.0), 0.25);
}

TEST(PredictDriftShare, IsThreeTimesWhatLoopsTook) {
  const DriftShare share = PredictDriftShare(Loops(30), Options());
  EXPECT_NEAR(share.linear, 0.3, 1e-12);
  EXPECT_NEAR(share.angular, 0.45, 1e-12);
}

TEST(PredictDriftShare, DoesNotCountOneLoopInTwenty) {
  std::vector<DriftShare> loops = Loops(96);
  loops.insert(loops.begin(), 4, {0.9, 0.9});
  EXPECT_NEAR(PredictDriftShare(loops, Options()).linear, 0.3, 1e-12);
  loops.insert(loops.begin(), 4, {0.9, 0.9});
  EXPECT_EQ(PredictDriftShare(loops, Options()).linear, 1.0) << "and is all of the window at most";
}

TEST(PredictDriftShare, IsAllWhileLoopsAreFew) {
  EXPECT_EQ(PredictDriftShare(Loops(29), Options()).linear, 1.0);
  EXPECT_EQ(PredictDriftShare({}, Options()).angular, 1.0);
}

TEST(PredictDriftShare, IsNoLessThanTheOptionsSay) {
  MeasuredDriftOptions options = Options();
  options.min_window_share = 0.4;
  EXPECT_EQ(PredictDriftShare(Loops(30), options).linear, 0.4);
  EXPECT_EQ(PredictDriftShare(Loops(30), MeasuredDriftOptions()).linear, 1.0) << "off";
}

TEST(WithDriftShare, LeavesEveryEighthNodeItsWindows) {
  int num_narrowed = 0;
  for (int node = 0; node < 24; ++node) {
    LoopCandidate candidate;
    candidate.node = NodeId{node};
    candidate.linear_search_window = 2.0;
    candidate.angular_search_window = 0.4;
    const LoopCandidate narrowed = WithDriftShare(candidate, {0.5, 0.25});
    if (narrowed.linear_search_window == 2.0) {
      EXPECT_EQ(narrowed.angular_search_window, 0.4);
      continue;
    }
    EXPECT_DOUBLE_EQ(narrowed.linear_search_window, 1.0);
    EXPECT_DOUBLE_EQ(narrowed.angular_search_window, 0.1);
    ++num_narrowed;
  }
  EXPECT_EQ(num_narrowed, 21);
}

}  // namespace
}  // namespace loopscope
