// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/recording_hash.h"

#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/support/small_recording.h"

namespace loopscope {
namespace {

/// The hash of the small run after `change`, which may change the log, the options and the updates.
using Change = std::function<void(ScanLog&, Options&, std::vector<SlamUpdate>&)>;

std::uint64_t HashAfter(const Change& change) {
  const SmallRun run(30);
  ScanLog log = run.log();
  Options options;
  std::vector<SlamUpdate> updates = run.updates();
  change(log, options, updates);
  Recording recording(log, options);
  for (const SlamUpdate& update : updates) recording.Append(update);
  return HashOfRecording(recording);
}

double Next(double value) { return std::nextafter(value, 1e300); }

TEST(RecordingHash, OfEqualRecordingsIsEqual) {
  EXPECT_EQ(HashOfRecording(SmallRun(30).ToRecording()),
            HashOfRecording(SmallRun(30).ToRecording()));
}

TEST(RecordingHash, ChangesWithTheLastBitOfAnyValue) {
  const auto unchanged = HashAfter([](ScanLog&, Options&, auto&) {});
  const std::vector<Change> changes = {
      [](ScanLog& log, Options&, auto&) { log.name += "x"; },
      [](ScanLog& log, Options&, auto&) { log.base_from_laser.rotation = Next(0.0); },
      [](ScanLog& log, Options&, auto&) { log.scans[3].ranges[0] = 1.25f; },
      [](ScanLog& log, Options&, auto&) { log.scans[3].time = Next(log.scans[3].time); },
      [](ScanLog& log, Options&, auto&) { ++log.scans[29].num_odometry_before; },
      [](ScanLog& log, Options&, auto&) { log.odometry.pop_back(); },
      [](ScanLog& log, Options&, auto&) { ++log.notes[0].count; },
      [](ScanLog& log, Options&, auto&) { ++log.beam_geometries[1].num_beams; },
      [](ScanLog&, Options& options, auto&) { options.pose_graph.optimize_every_n_nodes += 1; },
      [](ScanLog&, Options&, auto& updates) { updates.pop_back(); },
      [](ScanLog&, Options&, auto& updates) { updates[2].step.outcome = StepOutcome::kInserted; },
      [](ScanLog&, Options&, auto& updates) {
        double& x = updates[2].step.local_from_base_prior.translation.x();
        x = Next(x);
      },
      [](ScanLog&, Options&, auto& updates) {
        updates[3].step.local_from_base_correlative.reset();
      },
      [](ScanLog&, Options&, auto& updates) {
        double& y = updates[2].step.local_from_base.translation.y();
        y = Next(y);
      },
      [](ScanLog&, Options&, auto& updates) {
        double& rotation = updates[0].node->local_from_base.rotation;
        rotation = Next(rotation);
      },
      [](ScanLog&, Options&, auto& updates) {
        double& x = updates[0].started_submap->local_from_submap.translation.x();
        x = Next(x);
      },
      [](ScanLog&, Options&, auto& updates) {
        for (SlamUpdate& update : updates) {
          if (update.finished_submap) return update.finished_submap.reset();
        }
      },
      [](ScanLog&, Options&, auto& updates) {
        double& score = updates[29].candidates[1].score;
        score = Next(score);
      },
      [](ScanLog&, Options&, auto& updates) {
        double& y = updates[29].candidates[1].submap_from_node.translation.y();
        y = 0.0;  // was -0.0
      },
      [](ScanLog&, Options&, auto& updates) {
        updates[29].candidates[0].verdict = Verdict::kAccepted;
      },
      [](ScanLog&, Options&, auto& updates) { ++updates[29].candidates[0].num_supporters; },
      [](ScanLog&, Options&, auto& updates) {
        double& window = updates[29].candidates[1].linear_search_window;
        window = Next(window);
      },
      [](ScanLog&, Options&, auto& updates) {
        std::swap(updates[29].candidates[0], updates[29].candidates[1]);
      },
      [](ScanLog&, Options&, auto& updates) {
        double& x = updates[29].optimization->global_from_node.back().translation.x();
        x = Next(x);
      },
      [](ScanLog&, Options&, auto& updates) {
        double& cost = updates[29].optimization->final_cost;
        cost = Next(cost);
      },
  };
  for (std::size_t i = 0; i < changes.size(); ++i) EXPECT_NE(HashAfter(changes[i]), unchanged) << i;
}

}  // namespace
}  // namespace loopscope
