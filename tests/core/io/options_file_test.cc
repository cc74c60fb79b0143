// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/options_file.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "core/io/lua_sandbox.h"
#include "core/io/stock_files.h"
#include "core/io/unused_stock_options.h"
#include "core/slam/option_values.h"
#include "tests/support/datasets.h"

namespace loopscope {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

// As the configurations of cartographer_ros look, with `changes` in their place.
std::string Configuration(const std::string& changes, const std::string& ros_options = "") {
  return "include \"map_builder.lua\"\n"
         "include \"trajectory_builder.lua\"\n"
         "options = {\n"
         "  map_builder = MAP_BUILDER,\n"
         "  trajectory_builder = TRAJECTORY_BUILDER,\n"
         "  map_frame = \"map\", num_laser_scans = 1, use_odometry = false,\n"
         "  num_subdivisions_per_laser_scan = 10, rangefinder_sampling_ratio = 1.,\n" +
         ros_options + "}\n" + changes + "\nreturn options\n";
}

OptionsFile Parse(const std::string& changes, const std::string& ros_options = "") {
  return ParseLuaOptions("test.lua", Configuration(changes, ros_options));
}

std::string ErrorOf(const std::string& changes, const std::string& ros_options = "") {
  try {
    Parse(changes, ros_options);
  } catch (const FileError& error) {
    return error.what();
  }
  return "no error";
}

TEST(ParseLuaOptions, TakesTheStockValuesWhereNothingIsSet) {
  Options expected = CartographerPreset();
  expected.trajectory_builder_2d.use_odometry = false;
  const OptionsFile file = Parse("MAP_BUILDER.use_trajectory_builder_2d = true");
  EXPECT_EQ(OptionsToText(file.options), OptionsToText(expected));
  EXPECT_THAT(file.notes, IsEmpty());
}

TEST(ParseLuaOptions, SetsWhatTheFileSets) {
  const OptionsFile file = Parse(
      "TRAJECTORY_BUILDER_2D.submaps.num_range_data = 35\n"
      "TRAJECTORY_BUILDER_2D.use_online_correlative_scan_matching = true\n"
      "TRAJECTORY_BUILDER_2D.real_time_correlative_scan_matcher.linear_search_window = 0.15\n"
      "POSE_GRAPH.optimization_problem.huber_scale = 1e2\n"
      "MAP_BUILDER.pose_graph.constraint_builder.min_score = 0.65\n"
      "TRAJECTORY_BUILDER.trajectory_builder_2d.max_range = 12");
  const LocalSlamOptions& local = file.options.trajectory_builder_2d;
  EXPECT_EQ(local.submaps.num_range_data, 35);
  EXPECT_TRUE(local.use_online_correlative_scan_matching);
  EXPECT_EQ(local.real_time_correlative_scan_matcher.linear_search_window, 0.15);
  EXPECT_EQ(local.range.max_range, 12.0);
  EXPECT_EQ(file.options.pose_graph.optimization_problem.huber_scale, 100.0);
  EXPECT_EQ(file.options.pose_graph.constraint_builder.min_score, 0.65);
}

TEST(ParseLuaOptions, TellsWhatItDoesNotUse) {
  const OptionsFile file = Parse(
      "TRAJECTORY_BUILDER_2D.use_imu_data = false\n"
      "TRAJECTORY_BUILDER_2D.submaps.grid_options_2d.grid_type = \"TSDF\"\n"
      "TRAJECTORY_BUILDER.pure_localization_trimmer = {max_submaps_to_keep = 3}\n"
      "POSE_GRAPH.global_sampling_ratio = 0.003",
      "use_landmarks = true, imu_sampling_ratio = 0.5, odometry_sampling_ratio = 1.");
  EXPECT_THAT(
      file.notes,
      ElementsAre(
          "TRAJECTORY_BUILDER.pure_localization_trimmer.max_submaps_to_keep = 3 is not used by "
          "Loopscope",
          "TRAJECTORY_BUILDER_2D.submaps.grid_options_2d.grid_type = \"TSDF\" is not used by "
          "Loopscope",
          "TRAJECTORY_BUILDER_2D.use_imu_data = false is not used by Loopscope",
          "imu_sampling_ratio = 0.5 is not used by Loopscope",
          "use_landmarks = true is not used by Loopscope"));
}

TEST(ParseLuaOptions, SaysNothingOfWhatShapesNoMap) {
  EXPECT_THAT(Parse("MAP_BUILDER.num_background_threads = 7\n"
                    "POSE_GRAPH.constraint_builder.log_matches = false\n"
                    "POSE_GRAPH.optimization_problem.ceres_solver_options.num_threads = 2",
                    "publish_to_tf = false, tracking_frame = \"imu\"")
                  .notes,
              IsEmpty());
}

TEST(ParseLuaOptions, KnowsScansThatAreCutAndPutTogetherAgain) {
  EXPECT_THAT(Parse("TRAJECTORY_BUILDER_2D.num_accumulated_range_data = 10").notes, IsEmpty());
  EXPECT_THAT(Parse("TRAJECTORY_BUILDER_2D.num_accumulated_range_data = 5").notes,
              ElementsAre(HasSubstr("num_accumulated_range_data = 5 is not used")));
}

TEST(ParseLuaOptions, NamesTheNearestOfUnknownAndRenamedKeysWithTheLine) {
  EXPECT_EQ(ErrorOf("POSE_GRAPH.optimize_every_n_scans = 3"),
            "test.lua:9: unknown option \"POSE_GRAPH.optimize_every_n_scans\"; did you mean "
            "POSE_GRAPH.optimize_every_n_nodes?");
  EXPECT_EQ(ErrorOf("\nTRAJECTORY_BUILDER_2D.use_imu = 3"),
            "test.lua:10: unknown option \"TRAJECTORY_BUILDER_2D.use_imu\"; did you mean "
            "TRAJECTORY_BUILDER_2D.use_imu_data?");
  EXPECT_EQ(ErrorOf("", "use_odom = true"),
            "test.lua:8: unknown option \"use_odom\"; did you mean use_odometry?");
}

TEST(ParseLuaOptions, NamesValueRangeAndLineOfWhatDoesNotFit) {
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.submaps.num_range_data = 0"),
            "test.lua:9: TRAJECTORY_BUILDER_2D.submaps.num_range_data = 0: expected a whole number "
            "from 1 to 1000000");
  EXPECT_EQ(ErrorOf("TRAJECTORY_BUILDER_2D.submaps.num_range_data = \"many\""),
            "test.lua:9: TRAJECTORY_BUILDER_2D.submaps.num_range_data = \"many\": expected a whole "
            "number from 1 to 1000000");
  EXPECT_THAT(ErrorOf("TRAJECTORY_BUILDER_2D.max_range = 0/0"),
              HasSubstr("nan: expected a number from 0.1 to 1000 [m]"));
}

TEST(ParseLuaOptions, MapsIn2DOnly) {
  EXPECT_EQ(
      ErrorOf("MAP_BUILDER.use_trajectory_builder_3d = true"),
      "test.lua:9: MAP_BUILDER.use_trajectory_builder_3d = true: expected false, as Loopscope "
      "maps in 2D");
}

TEST(ParseLuaOptions, MissesTheTablesThatAreNotReturned) {
  const auto error_of = [](const std::string& text) -> std::string {
    try {
      ParseLuaOptions("test.lua", text);
    } catch (const FileError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(error_of("return {}"), HasSubstr("test.lua: map_builder.pose_graph is missing"));
  EXPECT_THAT(error_of("include 'map_builder.lua' return {map_builder = MAP_BUILDER}"),
              HasSubstr("trajectory_builder.trajectory_builder_2d is missing"));
}

TEST(StockFile, SetsWhatLoopscopeUsesAndWhatItDoesNot) {
  const LuaRun run = RunLua({"test.lua", Configuration("")}, StockFile);
  Options options = CartographerPreset();
  // Less use_odometry, and more the five options that the configuration has itself.
  EXPECT_EQ(run.values.size(), OptionTable(&options).size() - 1 + UnusedStockOptions().size() + 5);
}

TEST(StockFile, SharesTheTablesThatConfigurationsChange) {
  const LuaRun run =
      RunLua({"test.lua",
              "include 'map_builder.lua' include 'trajectory_builder.lua'"
              "return {a = MAP_BUILDER.pose_graph == POSE_GRAPH,"
              "b = TRAJECTORY_BUILDER.trajectory_builder_2d == TRAJECTORY_BUILDER_2D,"
              "c = TRAJECTORY_BUILDER.trajectory_builder_3d == TRAJECTORY_BUILDER_3D,"
              "d = MAX_3D_RANGE == 60}"},
             StockFile);
  for (const auto& [key, value] : run.values) EXPECT_EQ(value, ConfigValue(true)) << key;
}

std::string WriteFile(const std::string& name, const std::string& text) {
  const std::string path = ::testing::TempDir() + "/" + name;
  std::ofstream(path) << text;
  return path;
}

TEST(ReadOptionsFile, ReadsLua) {
  const std::string path =
      WriteFile("options.lua", Configuration("TRAJECTORY_BUILDER_2D.max_range = 9"));
  EXPECT_EQ(ReadOptionsFile(path).options.trajectory_builder_2d.range.max_range, 9.0);
}

TEST(ReadOptionsFile, ReadsWhatOptionsToTextWrites) {
  Options options = CartographerPreset();
  options.trajectory_builder_2d.range.max_range = 9.0;
  const std::string path = WriteFile("options.txt", OptionsToText(options));
  EXPECT_EQ(OptionsToText(ReadOptionsFile(path).options), OptionsToText(options));
}

TEST(ReadOptionsFile, NamesFileAndLineOfWhatDoesNotFit) {
  const std::string path = WriteFile("wrong.txt", "use_odometry = true\nuse_odometry = 3\n");
  try {
    ReadOptionsFile(path);
    FAIL() << "expected an exception";
  } catch (const FileError& error) {
    EXPECT_EQ(error.what(), path + ":2: use_odometry = 3: expected true or false");
  }
}

TEST(ReadOptionsFile, RefusesWhatIsNoTextFile) {
  EXPECT_THROW(ReadOptionsFile("/nonexistent/options.lua"), FileError);
  EXPECT_THROW(ReadOptionsFile(::testing::TempDir()), FileError);
  EXPECT_THROW(ReadOptionsFile(WriteFile("huge.lua", std::string(2 << 20, ' '))), FileError);
}

TEST(ReadOptionsFile, ReadsAConfigurationFromTheWild) {
  const std::string path =
      (DatasetsFolder() / "pbstream/legndy_config/rplidar_mapping.lua").string();
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  const OptionsFile file = ReadOptionsFile(path);
  Options expected = CartographerPreset();
  expected.trajectory_builder_2d.use_online_correlative_scan_matching = true;
  expected.trajectory_builder_2d.use_odometry = false;
  EXPECT_EQ(OptionsToText(file.options), OptionsToText(expected));
  EXPECT_THAT(file.notes, ElementsAre(HasSubstr("use_imu_data = false is not used")));
}

}  // namespace
}  // namespace loopscope
