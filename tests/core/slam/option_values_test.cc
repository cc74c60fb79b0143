// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/option_values.h"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/simulation/random.h"

namespace loopscope {
namespace {

std::string ErrorOf(const std::string& assignment) {
  Options options;
  try {
    SetFromAssignment(assignment, &options);
  } catch (const OptionError& error) {
    return error.what();
  }
  return "no error";
}

TEST(SetFromAssignment, SetsNumbersCountsAndFlags) {
  Options options;
  SetFromAssignment("TRAJECTORY_BUILDER_2D.max_range = 12.5", &options);
  EXPECT_EQ(options.trajectory_builder_2d.range.max_range, 12.5);
  SetFromAssignment("POSE_GRAPH.optimize_every_n_nodes=20", &options);
  EXPECT_EQ(options.pose_graph.optimize_every_n_nodes, 20);
  SetFromAssignment("use_odometry=false", &options);
  EXPECT_FALSE(options.trajectory_builder_2d.use_odometry);
}

TEST(SetFromAssignment, TakesWholeNumbersInAnyNotation) {
  Options options;
  SetFromAssignment("TRAJECTORY_BUILDER_2D.max_range=12", &options);
  EXPECT_EQ(options.trajectory_builder_2d.range.max_range, 12.0);
  SetFromAssignment("POSE_GRAPH.optimize_every_n_nodes=2e1", &options);
  EXPECT_EQ(options.pose_graph.optimize_every_n_nodes, 20);
}

TEST(SetFromAssignment, NamesKeyValueAndRangeOfWhatDoesNotFit) {
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.max_range=-1"),
            "TRAJECTORY_BUILDER_2D.max_range = -1: expected a number from 0.1 to 1000 [m]");
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.max_range=nan"),
            "TRAJECTORY_BUILDER_2D.max_range = nan: expected a number from 0.1 to 1000 [m]");
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.max_range=far"),
            "TRAJECTORY_BUILDER_2D.max_range = \"far\": expected a number from 0.1 to 1000 [m]");
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.max_range=1 m"),
            "TRAJECTORY_BUILDER_2D.max_range = \"1 m\": expected a number from 0.1 to 1000 [m]");
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.max_range=true"),
            "TRAJECTORY_BUILDER_2D.max_range = true: expected a number from 0.1 to 1000 [m]");
  EXPECT_EQ(ErrorOf("POSE_GRAPH.optimize_every_n_nodes=2.5"),
            "POSE_GRAPH.optimize_every_n_nodes = 2.5: expected a whole number from 0 to 1000000");
  EXPECT_EQ(ErrorOf("use_odometry=1"), "use_odometry = 1: expected true or false");
}

TEST(SetFromAssignment, AsksForAnEqualsSign) {
  EXPECT_EQ(ErrorOf("use_odometry"), "\"use_odometry\": expected key=value");
}

TEST(SetFromAssignment, NamesTheNearestOfUnknownAndRenamedKeys) {
  const auto expect_nearest = [](const std::string& key, const std::string& nearest) {
    EXPECT_EQ(ErrorOf(key + "=1"), "unknown option \"" + key + "\"; did you mean " + nearest + "?");
  };
  expect_nearest("POSE_GRAPH.optimize_evry_n_nodes", "POSE_GRAPH.optimize_every_n_nodes");
  expect_nearest("SPARSE_POSE_GRAPH.optimize_every_n_scans", "POSE_GRAPH.optimize_every_n_nodes");
  expect_nearest("max_range", "TRAJECTORY_BUILDER_2D.max_range");
  expect_nearest("TRAJECTORY_BUILDER_2D.laser_min_range", "TRAJECTORY_BUILDER_2D.min_range");
  expect_nearest("TRAJECTORY_BUILDER_2D.submaps.resolution",
                 "TRAJECTORY_BUILDER_2D.submaps.grid_options_2d.resolution");
  expect_nearest("POSE_GRAPH.huber_scale", "POSE_GRAPH.optimization_problem.huber_scale");
}

// Options with every number anywhere in its range.
Options RandomOptions(Random& random) {
  Options options;
  for (const OptionRow& row : OptionTable(&options)) {
    const double value = random.Uniform(row.minimum, row.maximum);
    if (std::holds_alternative<bool*>(row.field)) {
      SetValue(random.Uniform() < 0.5, row);
    } else {
      SetValue(std::holds_alternative<int*>(row.field) ? std::ceil(value) : value, row);
    }
  }
  return options;
}

TEST(OptionsToText, RoundTripsBitForBit) {
  Random random(5);
  for (int i = 0; i < 20; ++i) {
    Options options = RandomOptions(random);
    Options again = ParseOptions(OptionsToText(options), LoopscopePreset());
    const std::vector<OptionRow> rows = OptionTable(&options);
    const std::vector<OptionRow> rows_again = OptionTable(&again);
    for (size_t k = 0; k < rows.size(); ++k) {
      EXPECT_EQ(GetValue(rows[k]), GetValue(rows_again[k])) << rows[k].key;
    }
  }
}

TEST(OptionsToText, WritesShortNumbers) {
  EXPECT_THAT(OptionsToText(CartographerPreset()),
              ::testing::HasSubstr("\nTRAJECTORY_BUILDER_2D.min_range = 0\n"
                                   "TRAJECTORY_BUILDER_2D.max_range = 30\n"));
  EXPECT_THAT(OptionsToText(CartographerPreset()), ::testing::HasSubstr("resolution = 0.05\n"));
}

TEST(ParseOptions, TakesTheRestFromTheDefaults) {
  const Options options =
      ParseOptions("# a comment\n\n  use_odometry = false  \r\n", LoopscopePreset());
  EXPECT_FALSE(options.trajectory_builder_2d.use_odometry);
  EXPECT_EQ(options.trajectory_builder_2d.submaps.num_range_data,
            LoopscopePreset().trajectory_builder_2d.submaps.num_range_data);
}

TEST(ParseOptions, NamesTheLine) {
  try {
    ParseOptions("# first\nuse_odometry = true\nuse_odometry = maybe\n", Options());
    FAIL() << "expected an exception";
  } catch (const OptionError& error) {
    EXPECT_EQ(error.line(), 3);
    EXPECT_STREQ(error.what(), "use_odometry = \"maybe\": expected true or false");
  }
}

}  // namespace
}  // namespace loopscope
