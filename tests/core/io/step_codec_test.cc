// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/step_codec.h"

#include <limits>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "core/simulation/random.h"

namespace loopscope {
namespace {

/// Of a robot that drives on and turns; every third was matched by the correlative matcher.
std::vector<Step> SomeSteps(bool rounded) {
  Random random(3);
  const auto made = [&](const Pose2& pose) { return rounded ? Rounded(pose) : pose; };
  std::vector<Step> steps(50);
  Pose2 pose(1.0, 2.0, 3.0);
  for (std::size_t i = 0; i < steps.size(); ++i) {
    pose = pose * Pose2(0.1, random.Uniform(-0.01, 0.01), 0.1);
    steps[i].local_from_base_prior = made(pose * Pose2(random.Uniform(0.0, 0.02), 0.0, 0.01));
    if (i % 3 == 0) steps[i].local_from_base_correlative = made(pose * Pose2(0.003, 0.0, 0.002));
    steps[i].local_from_base = made(pose);
  }
  return steps;
}

std::string Packed(const std::vector<Step>& steps) {
  StepPoseCodec codec;
  ByteWriter out;
  for (const Step& step : steps) codec.Put(step, &out);
  return out.bytes();
}

std::vector<Step> Unpacked(const std::string& bytes, std::size_t count) {
  StepPoseCodec codec;
  ByteReader in(bytes, "file", "steps");
  std::vector<Step> steps(count);
  for (Step& step : steps) codec.Get(&in, &step);
  in.ExpectEnd();
  return steps;
}

void ExpectSameBack(const std::vector<Step>& steps) {
  const std::vector<Step> back = Unpacked(Packed(steps), steps.size());
  for (std::size_t i = 0; i < steps.size(); ++i) {
    EXPECT_EQ(back[i].local_from_base_prior, steps[i].local_from_base_prior) << i;
    EXPECT_EQ(back[i].local_from_base_correlative, steps[i].local_from_base_correlative) << i;
    EXPECT_EQ(back[i].local_from_base, steps[i].local_from_base) << i;
  }
}

TEST(StepPoseCodec, GivesRoundedPosesBackInFewBytes) {
  const std::vector<Step> steps = SomeSteps(true);
  ExpectSameBack(steps);
  EXPECT_LT(Packed(steps).size(), 19 * steps.size()) << "no more than three bytes a number";
}

TEST(StepPoseCodec, GivesAnyPosesBack) {
  ExpectSameBack(SomeSteps(false));
  std::vector<Step> steps = SomeSteps(true);
  steps[7].local_from_base = Pose2(1e300, -1e-300, 0.1);  // also as what the next are expected near
  ExpectSameBack(steps);
}

TEST(StepPoseCodec, ThrowsFileErrorOnWhatIsNoStep) {
  const std::string bytes = Packed(SomeSteps(true));
  EXPECT_THROW(Unpacked(bytes.substr(0, bytes.size() - 1), 50), FileError);
  EXPECT_THROW(Unpacked("\x08" + bytes, 50), FileError) << "unknown flags";
  ByteWriter far;
  far.PutByte(2);
  for (int i = 0; i < 6; ++i) far.PutSigned(std::numeric_limits<std::int64_t>::max());
  EXPECT_THROW(Unpacked(far.bytes(), 1), FileError);
}

}  // namespace
}  // namespace loopscope
