// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
//
// Recordings of older and newer versions.
#include "core/io/recording_schema.h"

#include <optional>
#include <string>

#include <SQLiteCpp/SQLiteCpp.h>
#include <SQLiteCpp/VariadicBind.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/small_recording_file.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

/// Takes the poses of steps apart, as they were stored until schema 2.
void UnpackSteps(const std::string& path, const Recording& recording) {
  SQLite::Database database(path, SQLite::OPEN_READWRITE);
  database.exec(
      "ALTER TABLE step RENAME TO packed;"
      "CREATE TABLE step (id INTEGER PRIMARY KEY, outcome INTEGER NOT NULL, prior_x, prior_y, "
      "prior_rotation, correlative_x, correlative_y, correlative_rotation, x, y, rotation, "
      "finished_submap INTEGER);"
      "INSERT INTO step (id, outcome, finished_submap) "
      "SELECT id, outcome, finished_submap FROM packed;"
      "DROP TABLE packed; PRAGMA user_version = 2");
  const auto set = [&](int step, const std::string& prefix, const Pose2& pose) {
    SQLite::Statement update(database, "UPDATE step SET " + prefix + "x = ?, " + prefix +
                                           "y = ?, " + prefix + "rotation = ? WHERE id = ?");
    SQLite::bind(update, pose.x(), pose.y(), pose.rotation, step);
    update.exec();
  };
  for (int i = 0; i < recording.num_steps(); ++i) {
    const Step& step = recording.step(i);
    set(i, "prior_", step.local_from_base_prior);
    if (step.local_from_base_correlative) set(i, "correlative_", *step.local_from_base_correlative);
    set(i, "", step.local_from_base);
  }
}

/// Of a recording that is changed to what another version wrote.
class RecordingSchema : public testing::Test {
 protected:
  RecordingSchema() { Write(path_, SmallRun(25)); }

  const TemporaryFolder folder_;
  const std::string path_ = folder_.Path("a.loopscope");
};

TEST_F(RecordingSchema, ReadsTheFirstSchemaWhichHadNoDriftShares) {
  const Recording written = ReadRecording(path_);
  UnpackSteps(path_, written);
  Execute(path_,
          "ALTER TABLE optimization DROP COLUMN linear_drift_share;"
          "ALTER TABLE optimization DROP COLUMN angular_drift_share;"
          "PRAGMA user_version = 1");
  const Recording read = ReadRecording(path_);
  ASSERT_GT(read.optimizations().size(), 0u);
  ASSERT_EQ(read.optimizations().size(), written.optimizations().size());
  EXPECT_EQ(read.optimizations()[0].drift_share.linear, 1.0);
  EXPECT_EQ(read.optimizations()[0].drift_share.angular, 1.0);
  EXPECT_EQ(read.optimizations()[0].global_from_node, written.optimizations()[0].global_from_node);
}

TEST_F(RecordingSchema, ReadsTheSecondSchemaWhichHadAColumnForEachNumberOfAStep) {
  const Recording written = ReadRecording(path_);
  UnpackSteps(path_, written);
  const Recording read = ReadRecording(path_);
  ASSERT_EQ(read.num_steps(), 25);
  for (int i = 0; i < 25; ++i) {
    SCOPED_TRACE(i);
    EXPECT_EQ(read.step(i).local_from_base_prior, written.step(i).local_from_base_prior);
    EXPECT_EQ(read.step(i).local_from_base_correlative,
              written.step(i).local_from_base_correlative);
    EXPECT_EQ(read.step(i).local_from_base, written.step(i).local_from_base);
    EXPECT_EQ(read.step(i).outcome, written.step(i).outcome);
    EXPECT_EQ(read.step(i).match_start, std::nullopt);
  }
  EXPECT_EQ(read.submaps()[0].finished_step, written.submaps()[0].finished_step);
}

TEST_F(RecordingSchema, ReadsTheThirdSchemaWhichCalibratedTheDirectionOfOdometryAlone) {
  Execute(path_,
          "UPDATE option SET key = 'TRAJECTORY_BUILDER_2D.odometry_direction_memory', value = '7' "
          "WHERE key = 'TRAJECTORY_BUILDER_2D.odometry_calibration_memory';"
          "PRAGMA user_version = 3");
  EXPECT_EQ(ReadRecording(path_).options().trajectory_builder_2d.odometry_calibration_memory, 7.0);
}

TEST_F(RecordingSchema, ReadsTheFifthSchemaWhichDidNotTellOfWideWalls) {
  Execute(path_, "ALTER TABLE step DROP COLUMN wide_walls; PRAGMA user_version = 5");
  const Recording read = ReadRecording(path_);
  ASSERT_EQ(read.num_steps(), 25);
  EXPECT_FALSE(read.step(24).wide_walls);
}

TEST_F(RecordingSchema, ThrowsIfItIsNewer) {
  Execute(path_, "PRAGMA user_version = 7");
  EXPECT_EQ(MessageOf([&] { ReadRecording(path_); }),
            path_ + ": recording of schema 7, made by a newer Loopscope; expected at most 6");
}

}  // namespace
}  // namespace loopscope
