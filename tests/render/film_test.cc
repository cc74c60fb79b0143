// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/film.h"

#include <stdexcept>

#include <gmock/gmock.h>

#include "tests/support/mapped_log.h"

namespace loopscope {
namespace {

using testing::HasSubstr;

TEST(ParseStepRangeTest, ReadsFirstLastAndStride) {
  const StepRange range = ParseStepRange("5:22:10", 100);
  EXPECT_EQ(range.count(), 2);
  EXPECT_EQ(range.step(0), 5);
  EXPECT_EQ(range.step(1), 15);
  EXPECT_EQ(ParseStepRange("5:25:10", 100).count(), 3);
}

TEST(ParseStepRangeTest, ReachesFromTheFirstToTheLastStepWhereNothingIsSaid) {
  const StepRange range = ParseStepRange("::7", 100);
  EXPECT_EQ(range.first, 0);
  EXPECT_EQ(range.last, 99);
  EXPECT_EQ(range.stride, 7);
  EXPECT_EQ(ParseStepRange("4:", 100).stride, 1);
}

TEST(ParseStepRangeTest, RefusesWhatIsNoRangeOfTheRecording) {
  for (const char* text : {"", "5", "a:b", "5:4", "-1:4", "0:100", "0:9:0", "0:9:", "0:9:1:1"}) {
    try {
      ParseStepRange(text, 100);
      FAIL() << "nothing was thrown for " << text;
    } catch (const std::invalid_argument& error) {
      EXPECT_THAT(error.what(), HasSubstr("expected FIRST:LAST")) << text;
      EXPECT_THAT(error.what(), HasSubstr("from 0 to 99")) << text;
    }
  }
}

class WithCameraOfTest : public testing::Test {
 protected:
  WithCameraOfTest() { request_.view = ViewKind::kMap; }

  FlatCamera CameraAt(const ViewRequest& request, int step) {
    ViewRequest at = request;
    at.step = step;
    return BuildScene(&cache_, at).panels.front().camera;
  }

  const Recording recording_ = MapLog(SimulateSmallLoop().log, SmallLoopOptions());
  DerivedCache cache_{recording_};
  ViewRequest request_;
};

TEST_F(WithCameraOfTest, AllStepsAreSeenAsTheOneThatWasNamed) {
  const FlatCamera expected = CameraAt(request_, 150);
  const ViewRequest fixed = WithCameraOf(&cache_, request_, 150);
  ASSERT_NE(CameraAt(request_, 10).meters_per_pixel, expected.meters_per_pixel);
  for (const int step : {10, 80, 150}) {
    const FlatCamera camera = CameraAt(fixed, step);
    EXPECT_EQ(camera.center, expected.center);
    EXPECT_NEAR(camera.meters_per_pixel, expected.meters_per_pixel, 1e-12);
  }
}

TEST_F(WithCameraOfTest, WhatTheRequestSaysOfTheCameraStays) {
  request_.center = Eigen::Vector2d(1.0, 2.0);
  request_.width_in_meters = 3.0;
  const ViewRequest fixed = WithCameraOf(&cache_, request_, 150);
  EXPECT_EQ(*fixed.center, Eigen::Vector2d(1.0, 2.0));
  EXPECT_EQ(*fixed.width_in_meters, 3.0);
}

TEST_F(WithCameraOfTest, ViewsOfASubmapFollowIt) {
  request_.view = ViewKind::kSubmap;
  EXPECT_FALSE(WithCameraOf(&cache_, request_, 150).center.has_value());
}

}  // namespace
}  // namespace loopscope
