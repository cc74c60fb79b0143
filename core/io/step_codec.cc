// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/step_codec.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/io/bits.h"
#include "core/io/multiples.h"

namespace loopscope {
namespace {

// Flags of the first byte. Part of the format.
constexpr std::uint8_t kHasCorrelative = 1;
constexpr std::uint8_t kIsRounded = 2;

constexpr double kScale = 1e6;  ///< of Rounded

using Numbers = std::array<double, 3>;
using Multiples = std::array<std::int64_t, 3>;

Numbers NumbersOf(const Pose2& pose) { return {pose.x(), pose.y(), pose.rotation}; }
Pose2 PoseOf(const Numbers& numbers) { return {numbers[0], numbers[1], numbers[2]}; }

Multiples MultiplesOf(const Pose2& pose) {
  Multiples multiples{};
  const Numbers numbers = NumbersOf(pose);
  for (std::size_t i = 0; i < numbers.size(); ++i) multiples[i] = Multiple(numbers[i], kScale);
  return multiples;
}

Pose2 FromMultiples(const Multiples& multiples) {
  Numbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    numbers[i] = FromMultiple(multiples[i], kScale);
  }
  return PoseOf(numbers);
}

bool IsRounded(const Pose2& pose) {
  const Numbers numbers = NumbersOf(pose);
  return std::all_of(numbers.begin(), numbers.end(),
                     [](double number) { return IsMultiple(number, kScale); });
}

bool IsRounded(const Step& step) {
  return IsRounded(step.local_from_base_prior) && IsRounded(step.local_from_base) &&
         (!step.local_from_base_correlative || IsRounded(*step.local_from_base_correlative));
}

void PutDifference(const Pose2& pose, const Pose2& expected, ByteWriter* out) {
  const Multiples multiples = MultiplesOf(pose);
  const Multiples expected_multiples = MultiplesOf(expected);
  for (std::size_t i = 0; i < multiples.size(); ++i) {
    out->PutSigned(multiples[i] - expected_multiples[i]);
  }
}

Pose2 GetDifferent(const Pose2& expected, ByteReader* in) {
  Multiples multiples = MultiplesOf(expected);
  for (std::int64_t& multiple : multiples) multiple = GetMultiple(multiple, in);
  return FromMultiples(multiples);
}

void PutPose(const Pose2& pose, const Pose2& expected, bool is_rounded, ByteWriter* out) {
  if (is_rounded) return PutDifference(pose, expected, out);
  for (const double number : NumbersOf(pose)) out->PutBits64(BitsOf(number));
}

Pose2 GetPose(const Pose2& expected, bool is_rounded, ByteReader* in) {
  if (is_rounded) return GetDifferent(expected, in);
  Numbers numbers{};
  for (double& number : numbers) number = DoubleOf(in->GetBits64());
  return PoseOf(numbers);
}

}  // namespace

void StepPoseCodec::Put(const Step& step, ByteWriter* out) {
  const auto& correlative = step.local_from_base_correlative;
  const bool is_rounded = IsRounded(step);
  out->PutByte((correlative ? kHasCorrelative : 0) | (is_rounded ? kIsRounded : 0));
  PutPose(step.local_from_base_prior, Prediction(), is_rounded, out);
  if (correlative) PutPose(*correlative, step.local_from_base_prior, is_rounded, out);
  PutPose(step.local_from_base, correlative.value_or(step.local_from_base_prior), is_rounded, out);
  Remember(step.local_from_base);
}

void StepPoseCodec::Get(ByteReader* in, Step* step) {
  const std::uint8_t flags = in->GetByte();
  if ((flags & ~(kHasCorrelative | kIsRounded)) != 0) in->Fail("unknown flags");
  const bool is_rounded = (flags & kIsRounded) != 0;
  auto& correlative = step->local_from_base_correlative;
  step->local_from_base_prior = GetPose(Prediction(), is_rounded, in);
  if ((flags & kHasCorrelative) != 0) {
    correlative = GetPose(step->local_from_base_prior, is_rounded, in);
  }
  step->local_from_base =
      GetPose(correlative.value_or(step->local_from_base_prior), is_rounded, in);
  Remember(step->local_from_base);
}

Pose2 StepPoseCodec::Prediction() const {
  return {2.0 * last_.translation - before_last_.translation,
          2.0 * last_.rotation - before_last_.rotation};
}

void StepPoseCodec::Remember(const Pose2& pose) {
  before_last_ = last_;
  last_ = pose;
}

}  // namespace loopscope
