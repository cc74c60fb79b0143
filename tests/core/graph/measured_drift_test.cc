// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/graph/measured_drift.h"

#include <gtest/gtest.h>

namespace loopscope {
namespace {

TEST(MeasuredDrift, IsOfTheLoopsInForce) {
  MeasuredDriftOptions options;
  options.min_window_share = 0.01;
  OutlierOptions outliers;
  outliers.max_distance = 0.3;
  GraphState graph;
  graph.global_from_submap = {Pose2()};
  graph.global_from_node = {Pose2(1.0, 0.0, 0.0)};
  MeasuredDrift drift(options, outliers);
  const auto loop_to = [](const Pose2& submap_from_node) {
    return Constraint{SubmapId{0}, NodeId{0}, submap_from_node,
                      1.0,         1.0,       Constraint::Tag::kInterSubmap};
  };
  for (int i = 0; i < 30; ++i) {
    drift.Note(loop_to(Pose2(1.0, 0.0, 0.0)), {0.1, 0.2});
    drift.Note(loop_to(Pose2(1.0, 0.5, 0.0)), {0.3, 0.3});
  }
  EXPECT_NEAR(drift.Predict(graph).linear, 0.3, 1e-12);
  EXPECT_NEAR(drift.Predict(graph).angular, 0.6, 1e-12);
  graph.global_from_node = {Pose2(1.0, 0.5, 0.0)};
  EXPECT_NEAR(drift.Predict(graph).linear, 0.9, 1e-12);
}

}  // namespace
}  // namespace loopscope
