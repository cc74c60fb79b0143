// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/matching/scan_match_refinement.h"

#include <cmath>

#include <gmock/gmock.h>

#include "core/matching/scan_match_cost.h"
#include "tests/support/ceres_scan_match.h"
#include "tests/support/pose_matchers.h"
#include "tests/support/simulated_room.h"

namespace loopscope {
namespace {

const CeresScanMatcherOptions kWeakPriors{1.0, 0.1, 0.1, 50};

double CostAt(const PointCloud& points, const ProbabilityGrid& grid, const Pose2& start,
              const Pose2& pose, const CeresScanMatcherOptions& options) {
  const ScanMatchCost cost(points, grid, start.translation, start.rotation, options);
  return cost.At({pose.x(), pose.y(), pose.rotation}).cost;
}

TEST(RefineScanMatch, BringsAScanBackFromRandomOffsetsOfACell) {
  const SimulatedRoom room;
  Random random(1);
  for (int i = 0; i < 50; ++i) {
    const Pose2 truth{random.Uniform(1.0, 3.0), random.Uniform(-0.5, 1.5),
                      random.Uniform(-M_PI, M_PI)};
    const Pose2 start{truth.x() + random.Uniform(-0.05, 0.05),
                      truth.y() + random.Uniform(-0.05, 0.05),
                      truth.rotation + random.Uniform(-0.05, 0.05)};
    const RefinedMatch match =
        RefineScanMatch(room.ScanAt(truth), room.grid(), start.translation, start, kWeakPriors);
    EXPECT_THAT(match.submap_from_scan, PoseNear(truth, 0.01, 0.004))
        << "start " << testing::PrintToString(start);
  }
}

TEST(RefineScanMatch, EndsAtAMinimumOfItsCost) {
  const SimulatedRoom room;
  const Pose2 truth(2.0, 0.7, 0.4);
  const PointCloud points = room.ScanAt(truth);
  const Pose2 start = truth * Pose2(0.05, -0.03, 0.02);
  const RefinedMatch match =
      RefineScanMatch(points, room.grid(), start.translation, start, kWeakPriors);
  EXPECT_NEAR(match.initial_cost, CostAt(points, room.grid(), start, start, kWeakPriors), 1e-12);
  const Pose2& end = match.submap_from_scan;
  EXPECT_NEAR(match.final_cost, CostAt(points, room.grid(), start, end, kWeakPriors), 1e-12);
  EXPECT_LT(match.final_cost, 0.7 * match.initial_cost);
  EXPECT_GT(match.num_iterations, 1);
  for (const double step : {-2e-3, 2e-3}) {
    for (const Pose2& aside : {Pose2(end.x() + step, end.y(), end.rotation),
                               Pose2(end.x(), end.y() + step, end.rotation),
                               Pose2(end.x(), end.y(), end.rotation + step)}) {
      EXPECT_GT(CostAt(points, room.grid(), start, aside, kWeakPriors), match.final_cost);
    }
  }
}

TEST(RefineScanMatch, StaysWhereStrongPriorsHoldIt) {
  const SimulatedRoom room;
  const Pose2 truth(2.0, 0.7, 0.4);
  const Pose2 start = truth * Pose2(0.05, -0.03, 0.02);
  const RefinedMatch match = RefineScanMatch(room.ScanAt(truth), room.grid(), start.translation,
                                             start, {1.0, 1e4, 1e4, 50});
  EXPECT_THAT(match.submap_from_scan, PoseNear(start, 1e-5, 1e-5));
}

TEST(RefineScanMatch, IsPulledToTheTargetAndTheRotationOfTheStart) {
  // Off the map nothing but the priors is left.
  const ProbabilityGrid nothing_known(0.05);
  const RefinedMatch match = RefineScanMatch({{1.0, 0.0}}, nothing_known, {7.0, 8.0},
                                             Pose2(6.9, 8.2, 3.0), CeresScanMatcherOptions());
  EXPECT_THAT(match.submap_from_scan, PoseNear(Pose2(7.0, 8.0, 3.0), 1e-6, 1e-9));
}

TEST(RefineScanMatch, StopsAfterTheIterationsItIsAllowed) {
  const SimulatedRoom room;
  const Pose2 truth(2.0, 0.7, 0.4);
  CeresScanMatcherOptions options = kWeakPriors;
  options.max_num_iterations = 2;
  const Pose2 start = truth * Pose2(0.05, -0.03, 0.02);
  const RefinedMatch match =
      RefineScanMatch(room.ScanAt(truth), room.grid(), start.translation, start, options);
  EXPECT_LE(match.num_iterations, 2);
}

TEST(RefineScanMatch, NormalizesTheRotation) {
  const ProbabilityGrid nothing_known(0.05);
  const RefinedMatch match = RefineScanMatch({{1.0, 0.0}}, nothing_known, {0.0, 0.0},
                                             Pose2(0.1, 0.0, 7.0), CeresScanMatcherOptions());
  EXPECT_NEAR(match.submap_from_scan.rotation, 7.0 - 2.0 * M_PI, 1e-9);
}

TEST(RefineScanMatch, FindsWhatCeresFindsWithAutomaticDerivatives) {
  const SimulatedRoom room;
  const Pose2 truth(2.0, 0.8, 0.4);
  const PointCloud points = room.ScanAt(truth);
  CeresScanMatcherOptions options;
  options.max_num_iterations = 50;
  for (const Pose2& error : {Pose2(0.03, -0.04, 0.02), Pose2(-0.05, 0.02, -0.03)}) {
    const Pose2 start = truth * error;
    const RefinedMatch match =
        RefineScanMatch(points, room.grid(), start.translation, start, options);
    const RefinedMatch plain =
        MatchWithAutomaticDerivatives(points, room.grid(), start.translation, start, options);
    EXPECT_NEAR(match.initial_cost, plain.initial_cost, 1e-6 * plain.initial_cost);
    EXPECT_THAT(match.submap_from_scan, PoseNear(plain.submap_from_scan, 1e-4, 1e-4));
  }
}

}  // namespace
}  // namespace loopscope
