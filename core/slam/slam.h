// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "core/graph/pose_graph.h"
#include "core/local/local_slam.h"
#include "core/slam/recording.h"

namespace loopscope {

/// Mapping of a log, scan by scan: local SLAM builds submaps, loop searches run in the background,
/// and every so often the pose graph is optimized. The updates depend on log and options alone, not
/// on the number of threads.
class Slam {
 public:
  /// Keeps a reference to `log`. `num_threads` >= 1 is how many loop searches run at once.
  Slam(const ScanLog& log, const Options& options, int num_threads);

  /// Maps scan `scan` of the log; scans come in their order, beginning with 0. All that it caused
  /// is in the update, with the last scan the final optimization too.
  SlamUpdate AddScan(int scan);

 private:
  void AddNode(int scan, const LocalSlamResult& local, SlamUpdate* update);
  void FinishSubmap(int scan, ActiveSubmap finished, SlamUpdate* update);
  Optimization Optimize(int scan);
  /// The final optimization, with a last look for loops and without those that are false.
  Optimization Finish(int scan, SlamUpdate* update);

  const ScanLog& log_;
  Options options_;
  LocalSlam local_slam_;
  PoseGraph pose_graph_;
  int num_nodes_ = 0;
};

}  // namespace loopscope
