// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/slam/trajectories.h"

#include <cmath>

#include <gtest/gtest.h>

namespace loopscope {
namespace {

/// A log in the order of its events, and what was made of it.
class Drive {
 public:
  void AddOdometry(double time, const Pose2& odom_from_base) {
    log_.odometry.push_back({time, odom_from_base});
  }

  void AddScan(double time, const Pose2& local_from_base) {
    log_.scans.push_back({time, 0, {1.f}, static_cast<int>(log_.odometry.size())});
    SlamUpdate update;
    update.step.outcome = StepOutcome::kMotionFiltered;
    update.step.local_from_base = local_from_base;
    updates_.push_back(update);
  }

  void AddNode(double time, const Pose2& local_from_base, const Pose2& global_from_base) {
    AddScan(time, local_from_base);
    SlamUpdate& update = updates_.back();
    const NodeId id{static_cast<int>(global_from_node_.size())};
    update.step.outcome = StepOutcome::kInserted;
    update.step.node = id;
    if (id.index == 0) update.started_submap = Submap{Pose2(), id, 0, -1};
    const int step = static_cast<int>(updates_.size()) - 1;
    update.node = Node{step, local_from_base, SubmapId{0}, 1};
    global_from_node_.push_back(global_from_base);
  }

  Recording ToRecording(bool use_odometry = true) const {
    ScanLog log = log_;
    log.beam_geometries = {{1, 0.0, 0.0}};
    Options options;
    options.trajectory_builder_2d.use_odometry = use_odometry;
    Recording recording(log, options);
    std::vector<SlamUpdate> updates = updates_;
    Optimization optimization;
    optimization.step = static_cast<int>(updates.size()) - 1;
    optimization.global_from_submap = {Pose2()};
    optimization.global_from_node = global_from_node_;
    updates.back().optimization = optimization;
    for (const SlamUpdate& update : updates) recording.Append(update);
    return recording;
  }

 private:
  ScanLog log_;
  std::vector<SlamUpdate> updates_;
  std::vector<Pose2> global_from_node_;
};

MapState LastState(const Recording& recording) {
  return StateAfterStep(recording, recording.num_steps() - 1);
}

void ExpectPose(const TimedPose& pose, double time, const Pose2& expected) {
  EXPECT_EQ(pose.time, time);
  EXPECT_NEAR(pose.map_from_base.x(), expected.x(), 1e-12) << time;
  EXPECT_NEAR(pose.map_from_base.y(), expected.y(), 1e-12) << time;
  EXPECT_NEAR(NormalizeAngle(pose.map_from_base.rotation - expected.rotation), 0.0, 1e-12) << time;
}

/// A robot whose odometry says 1 m for each metre and a half. All of it is turned by 90 degrees
/// against the map.
Drive DriveWithOdometry() {
  Drive drive;
  drive.AddOdometry(0.0, Pose2(5.0, -1.0, 0.0));
  drive.AddOdometry(1.0, Pose2(6.0, -1.0, 0.0));
  drive.AddNode(1.0, Pose2(), Pose2(0.0, 0.0, M_PI / 2.0));
  drive.AddOdometry(2.0, Pose2(7.0, -1.0, 0.0));
  drive.AddScan(2.5, Pose2(1.6, 0.0, 0.0));
  drive.AddOdometry(3.0, Pose2(8.0, -1.0, 0.0));
  drive.AddNode(3.0, Pose2(3.0, 0.0, 0.0), Pose2(0.0, 3.0, M_PI / 2.0));
  drive.AddOdometry(4.0, Pose2(9.0, -1.0, 0.0));
  return drive;
}

TEST(DenseTrajectory, CarriesScansOnByOdometryAndSpreadsWhatIsMissing) {
  const Recording recording = DriveWithOdometry().ToRecording();
  const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
  ASSERT_EQ(trajectory.size(), 6u);
  ExpectPose(trajectory[0], 0.0, Pose2(0.0, -1.0, M_PI / 2.0));
  ExpectPose(trajectory[1], 1.0, Pose2(0.0, 0.0, M_PI / 2.0));
  ExpectPose(trajectory[2], 2.0, Pose2(0.0, 1.0 + 0.6 / 2.0, M_PI / 2.0));
  ExpectPose(trajectory[3], 2.5, Pose2(0.0, 1.6, M_PI / 2.0));
  ExpectPose(trajectory[4], 3.0, Pose2(0.0, 3.0, M_PI / 2.0));
  ExpectPose(trajectory[5], 4.0, Pose2(0.0, 4.0, M_PI / 2.0));
}

TEST(DenseTrajectory, CarriesNodesOnByLocalSlamAndSpreadsWhatLoopsMoved) {
  Drive drive;
  drive.AddOdometry(0.0, Pose2());
  drive.AddNode(0.0, Pose2(), Pose2());
  drive.AddScan(0.1, Pose2(1.0, 0.0, 0.0));
  drive.AddScan(0.2, Pose2(2.0, 0.0, 0.0));
  drive.AddScan(1.0, Pose2(3.0, 0.0, 0.0));
  drive.AddNode(2.0, Pose2(4.0, 0.0, 0.0), Pose2(4.0, 0.4, 0.0));
  drive.AddScan(3.0, Pose2(5.0, 0.0, 0.0));
  for (const bool use_odometry : {false, true}) {
    const Recording recording = drive.ToRecording(use_odometry);
    const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
    ASSERT_EQ(trajectory.size(), 6u);
    ExpectPose(trajectory[1], 0.1, Pose2(1.0, 0.1, 0.0));
    ExpectPose(trajectory[3], 1.0, Pose2(3.0, 0.3, 0.0));
    ExpectPose(trajectory[5], 3.0, Pose2(5.0, 0.4, 0.0));
  }
}

TEST(DenseTrajectory, DoesNotFollowOdometryThatJumps) {
  for (const Pose2& jump : {Pose2(30.0, -20.0, 0.0), Pose2(0.0, 0.0, 1.5)}) {
    Drive drive;
    drive.AddOdometry(0.0, Pose2());
    drive.AddNode(0.0, Pose2(), Pose2());
    drive.AddOdometry(1.0, jump * Pose2(0.5, 0.0, 0.0));
    drive.AddOdometry(2.0, jump * Pose2(1.0, 0.0, 0.0));
    drive.AddOdometry(3.0, jump * Pose2(1.5, 0.0, 0.0));
    drive.AddNode(4.0, Pose2(2.0, 0.0, 0.0), Pose2(2.0, 0.4, 0.0));
    drive.AddOdometry(5.0, jump * Pose2(2.0, 0.0, 0.0));
    const Recording recording = drive.ToRecording();
    const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
    ASSERT_EQ(trajectory.size(), 6u);
    ExpectPose(trajectory[1], 1.0, Pose2(0.5, 0.1, 0.0));
    ExpectPose(trajectory[3], 3.0, Pose2(1.5, 0.3, 0.0));
    ExpectPose(trajectory[5], 5.0, Pose2(2.5, 0.4, 0.0));
  }
}

TEST(DenseTrajectory, SpreadsTurnsTheShortWay) {
  Drive drive;
  drive.AddOdometry(0.0, Pose2());
  drive.AddNode(0.0, Pose2(), Pose2(0.0, 0.0, 3.0));
  drive.AddOdometry(1.0, Pose2(1.0, 0.0, 0.0));
  drive.AddOdometry(2.0, Pose2(2.0, 0.0, 0.0));
  drive.AddNode(2.0, Pose2(), Pose2(0.0, 0.0, -3.0));
  const Recording recording = drive.ToRecording();
  const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
  EXPECT_NEAR(std::abs(trajectory[1].map_from_base.rotation), M_PI, 1e-12);
}

TEST(DenseTrajectory, WithoutOdometryHasTheScansOfLocalSlam) {
  const Recording recording = DriveWithOdometry().ToRecording(/*use_odometry=*/false);
  const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
  ASSERT_EQ(trajectory.size(), 3u);
  ExpectPose(trajectory[0], 1.0, Pose2(0.0, 0.0, M_PI / 2.0));
  ExpectPose(trajectory[1], 2.5, Pose2(0.0, 1.6, M_PI / 2.0));
  ExpectPose(trajectory[2], 3.0, Pose2(0.0, 3.0, M_PI / 2.0));
}

TEST(DenseTrajectory, FollowsTheOrderOfTheLogAndComesInThatOfTheStamps) {
  Drive drive;
  drive.AddOdometry(0.0, Pose2());
  drive.AddNode(0.0, Pose2(), Pose2());
  drive.AddOdometry(2.0, Pose2(1.0, 0.0, 0.0));
  drive.AddOdometry(1.5, Pose2(2.0, 0.0, 0.0));
  drive.AddOdometry(3.0, Pose2(3.0, 0.0, 0.0));
  drive.AddNode(3.0, Pose2(), Pose2(3.0, 0.0, 0.0));
  const Recording recording = drive.ToRecording();
  const Trajectory trajectory = DenseTrajectory(recording, LastState(recording));
  ASSERT_EQ(trajectory.size(), 4u);
  ExpectPose(trajectory[1], 1.5, Pose2(2.0, 0.0, 0.0));
  ExpectPose(trajectory[2], 2.0, Pose2(1.0, 0.0, 0.0));
}

TEST(DenseTrajectory, EndsWithItsState) {
  const Recording recording = DriveWithOdometry().ToRecording();
  EXPECT_EQ(DenseTrajectory(recording, StateAfterStep(recording, 1)).back().time, 2.5);
  EXPECT_EQ(DenseTrajectory(recording, StateAfterStep(recording, 0)).back().time, 1.0);
}

TEST(NodeTrajectory, HasTheOptimizedPosesAtTheStampsOfTheScans) {
  const Recording recording = DriveWithOdometry().ToRecording();
  const Trajectory trajectory = NodeTrajectory(recording, LastState(recording));
  ASSERT_EQ(trajectory.size(), 2u);
  ExpectPose(trajectory[0], 1.0, Pose2(0.0, 0.0, M_PI / 2.0));
  ExpectPose(trajectory[1], 3.0, Pose2(0.0, 3.0, M_PI / 2.0));
}

}  // namespace
}  // namespace loopscope
