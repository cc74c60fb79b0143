// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <vector>

#include <gtest/gtest.h>

#include "core/local/scan_matching.h"
#include "core/matching/match_score.h"
#include "core/slam/derive.h"
#include "tests/support/mapped_log.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/small_loop_run.h"

namespace loopscope {
namespace {

TEST(ReplayMatch, MatchesAgainToTheRecordedPoseBitForBit) {
  const Recording& recording = SmallLoopRun();
  int num_replayed = 0;
  for (int step = 1; step < recording.num_steps(); step += 5) {
    SCOPED_TRACE(step);
    const auto replay = ReplayMatch(recording, step);
    ASSERT_TRUE(replay);
    EXPECT_FALSE(replay->wide_walls);
    MatchPrior prior{replay->submap_from_base_prior, true};
    prior.motion_size = SizeOf(recording.step(step - 1).local_from_base.Inverse() *
                               recording.step(step).local_from_base_prior);
    // With nothing expected of the score, nothing is searched for widely.
    const ScanMatch match = MatchScan(replay->points, replay->grid, prior, 0.0,
                                      recording.options().trajectory_builder_2d);
    const Pose2& local_from_submap = recording.submap(replay->submap).local_from_submap;
    EXPECT_EQ(Rounded(local_from_submap * match.submap_from_base),
              recording.step(step).local_from_base);
    ASSERT_TRUE(match.submap_from_base_correlative);
    EXPECT_EQ(Rounded(local_from_submap * *match.submap_from_base_correlative),
              recording.step(step).local_from_base_correlative);
    EXPECT_NEAR(replay->score, match.score, 1e-3);  // but for rounding of the pose
    ++num_replayed;
  }
  EXPECT_GT(num_replayed, 30);
}

TEST(ReplayMatch, HasTheWallsThatTheScanWasMatchedAgainst) {
  Options options = SmallLoopOptions();
  options.trajectory_builder_2d.use_odometry = false;  // so that they are wider
  const Recording recording = MapLog(SimulateSmallLoop().log, options);
  ASSERT_GT(options.trajectory_builder_2d.share_beside_walls, 0.0);
  int num_replayed = 0;
  for (int step = 10; step < recording.num_steps(); step += 5) {
    if (recording.step(step).match_start != MatchStart::kPrior) continue;
    SCOPED_TRACE(step);
    const auto replay = ReplayMatch(recording, step);
    ASSERT_TRUE(replay);
    EXPECT_TRUE(replay->wide_walls);
    const ScanMatch match =
        MatchScan(replay->points, replay->grid, {replay->submap_from_base_prior, false, {}}, 0.0,
                  options.trajectory_builder_2d);
    // The mapper began where the velocity had the robot before that was rounded.
    EXPECT_THAT(match.submap_from_base, PoseNear(replay->submap_from_base, 1e-3, 1e-3));
    ++num_replayed;
  }
  EXPECT_GT(num_replayed, 10);
}

TEST(ReplayMatch, TellsWherePriorAndMatchStandInTheSubmap) {
  const Recording& recording = SmallLoopRun();
  const auto replay = ReplayMatch(recording, 50);
  const Pose2& local_from_submap = recording.submap(replay->submap).local_from_submap;
  const Step& step = recording.step(50);
  EXPECT_THAT(local_from_submap * replay->submap_from_base_prior,
              PoseNear(step.local_from_base_prior, 1e-12, 1e-12));
  EXPECT_THAT(local_from_submap * replay->submap_from_base,
              PoseNear(step.local_from_base, 1e-12, 1e-12));
  EXPECT_EQ(replay->prior_score,
            MeanProbability(replay->points, replay->submap_from_base_prior, replay->grid));
  EXPECT_EQ(replay->score, MeanProbability(replay->points, replay->submap_from_base, replay->grid));
}

TEST(ReplayMatch, IsNothingForTheFirstScanAndForThoseWithTooFewReturns) {
  ScanLog log = SimulateSmallLoop().log;
  log.scans.resize(20);
  for (float& range : log.scans[10].ranges) range = 0.0f;
  std::vector<float>& few = log.scans[11].ranges;
  std::fill(few.begin() + 10, few.end(), 0.0f);
  const Recording recording = MapLog(log, SmallLoopOptions());
  EXPECT_FALSE(ReplayMatch(recording, 0));
  EXPECT_TRUE(ReplayMatch(recording, 9));
  EXPECT_FALSE(ReplayMatch(recording, 10));
  EXPECT_FALSE(ReplayMatch(recording, 11));
  EXPECT_EQ(recording.step(11).match_start, MatchStart::kNone);
}

}  // namespace
}  // namespace loopscope
