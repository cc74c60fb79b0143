// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_check.h"

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/small_recording.h"

namespace loopscope {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// A step that has all that a step can cause.
constexpr int kFullStep = 24;

/// The steps before it, and the step itself.
struct RunUntil {
  RunUntil() : small(kFullStep + 1), before(small.log(), CartographerPreset()) {
    for (int step = 0; step < kFullStep; ++step) before.Append(small.updates()[step]);
    update = small.updates()[kFullStep];
  }

  SmallRun small;
  Recording before;
  SlamUpdate update;
};

TEST(RecordingCheck, FindsNoFaultInARun) {
  const RunUntil run;
  EXPECT_EQ(FaultOf(run.small.log()), std::nullopt);
  ASSERT_TRUE(run.update.started_submap && run.update.node && run.update.optimization);
  ASSERT_EQ(run.update.candidates.size(), 4u);
  EXPECT_EQ(FaultOf(run.update, run.before), std::nullopt);
}

TEST(RecordingCheck, NamesWhatIsWrongWithAStep) {
  const std::vector<std::pair<std::string, std::function<void(SlamUpdate*)>>> faults = {
      {"a pose that is not finite",
       [](auto* u) { u->step.local_from_base.translation.x() = kNan; }},
      {"a submap that misses some before it",
       [](auto* u) { u->started_submap->first_node.index = 3; }},
      {"not in the last submaps", [](auto* u) { --u->node->first_submap.index; }},
      {"submaps that are not there", [](auto* u) { u->node->num_submaps = 3; }},
      {"a loop to a submap", [](auto* u) { u->candidates[0].submap.index = 99; }},
      {"a loop to a node", [](auto* u) { u->candidates[0].node.index = -1; }},
      {"a loop from a later step", [](auto* u) { u->candidates[0].considered_step = 25; }},
      {"before its node or submap", [](auto* u) { u->candidates[0].considered_step = 0; }},
      {"search window", [](auto* u) { u->candidates[1].linear_search_window = kNan; }},
      {"search window", [](auto* u) { u->candidates[1].linear_search_window = 30.1; }},
      {"search window", [](auto* u) { u->candidates[1].angular_search_window = -0.1; }},
      {"score is not finite", [](auto* u) { u->candidates[1].rival_score = kNan; }},
      {"pose is nowhere", [](auto* u) { u->candidates[1].submap_from_node.rotation = kNan; }},
      {"wrong number of poses", [](auto* u) { u->optimization->global_from_node.pop_back(); }},
      {"pose is nowhere",
       [](auto* u) { u->started_submap->local_from_submap.translation.x() = 2e6; }},
      {"pose is nowhere", [](auto* u) { u->node->local_from_base.translation.y() = -1e10; }},
      {"pose is nowhere", [](auto* u) { u->started_submap->local_from_submap.rotation = kNan; }},
      {"poses that are nowhere",
       [](auto* u) { u->optimization->global_from_submap[0].translation.x() = 1e200; }},
      {"cost makes no sense", [](auto* u) { u->optimization->final_cost = 1e308; }},
      {"cost makes no sense", [](auto* u) { u->optimization->initial_cost = kNan; }},
      {"share of windows", [](auto* u) { u->optimization->drift_share.angular = kNan; }},
      {"share of windows", [](auto* u) { u->optimization->drift_share.linear = 1.1; }},
  };
  for (const auto& [expected, spoil] : faults) {
    RunUntil run;
    spoil(&run.update);
    const auto fault = FaultOf(run.update, run.before);
    ASSERT_TRUE(fault) << expected;
    EXPECT_NE(fault->find(expected), std::string::npos) << *fault;
  }
}

TEST(RecordingCheck, WantsNoOptimizationBeforeTheFirstNode) {
  const SmallRun small(1);
  SlamUpdate update;
  update.optimization.emplace();
  EXPECT_EQ(FaultOf(update, Recording(small.log(), CartographerPreset())),
            "an optimization before the first node");
}

TEST(RecordingCheck, NamesWhatIsWrongWithALog) {
  const std::vector<std::pair<std::string, std::function<void(ScanLog*)>>> faults = {
      {"a scanner whose pose", [](auto* log) { log->base_from_laser.rotation = kNan; }},
      {"beams whose angles", [](auto* log) { log->beam_geometries[1].angle_increment = kNan; }},
      {"odometry that is not finite", [](auto* log) { log->odometry[2].time = kNan; }},
      {"odometry that is not finite",
       [](auto* log) { log->odometry[2].odom_from_base.rotation = kNan; }},
      {"a scan whose time", [](auto* log) { log->scans[2].time = kNan; }},
      {"a scan without beams", [](auto* log) { log->scans[2].beam_geometry = 2; }},
      {"wrong number of ranges", [](auto* log) { log->scans[2].ranges.pop_back(); }},
      {"amid odometry", [](auto* log) { log->scans[2].num_odometry_before = 9; }},
  };
  for (const auto& [expected, spoil] : faults) {
    ScanLog log = SmallRun(3).log();
    spoil(&log);
    const auto fault = FaultOf(log);
    ASSERT_TRUE(fault) << expected;
    EXPECT_NE(fault->find(expected), std::string::npos) << *fault;
  }
}

}  // namespace
}  // namespace loopscope
