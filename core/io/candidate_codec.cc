// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/candidate_codec.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/io/number_codec.h"

namespace loopscope {
namespace {

using Candidates = std::vector<LoopCandidate>;
using Kinds = std::vector<std::uint8_t>;

constexpr std::size_t kMinBytesPerCandidate = 4;

// The first byte of each: its verdict, and what it has besides ids and steps. Part of the format.
constexpr std::uint8_t kVerdictMask = 15;
constexpr std::uint8_t kWholeSubmap = 16;
constexpr std::uint8_t kHasSearch = 32;       ///< kNumbers, the guess, the pose found, supporters
constexpr std::uint8_t kHasRefinedPose = 64;  ///< submap_from_node
constexpr std::uint8_t kLastLook = 128;

constexpr std::array<double LoopCandidate::*, 6> kNumbers = {&LoopCandidate::linear_search_window,
                                                             &LoopCandidate::angular_search_window,
                                                             &LoopCandidate::score,
                                                             &LoopCandidate::score_bound,
                                                             &LoopCandidate::min_score,
                                                             &LoopCandidate::rival_score};

bool IsDefault(double value) { return value == 0.0 && !std::signbit(value); }

bool IsDefault(const Pose2& pose) {
  return IsDefault(pose.x()) && IsDefault(pose.y()) && IsDefault(pose.rotation);
}

bool HasSearch(const LoopCandidate& candidate) {
  const auto is_set = [&](double LoopCandidate::*number) { return !IsDefault(candidate.*number); };
  return std::any_of(kNumbers.begin(), kNumbers.end(), is_set) || candidate.num_supporters != 0 ||
         !IsDefault(candidate.submap_from_node_guess) ||
         !IsDefault(candidate.submap_from_node_searched);
}

std::uint8_t KindOf(const LoopCandidate& candidate) {
  return static_cast<std::uint8_t>(
      static_cast<int>(candidate.verdict) | (candidate.whole_submap ? kWholeSubmap : 0) |
      (candidate.last_look ? kLastLook : 0) | (HasSearch(candidate) ? kHasSearch : 0) |
      (IsDefault(candidate.submap_from_node) ? 0 : kHasRefinedPose));
}

/// The values of `member` in the candidates whose kind has `flag`.
template <typename Value>
std::vector<Value> Column(const Candidates& candidates, const Kinds& kinds, std::uint8_t flag,
                          Value LoopCandidate::*member) {
  std::vector<Value> column;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if ((kinds[i] & flag) != 0) column.push_back(candidates[i].*member);
  }
  return column;
}

/// The reverse.
template <typename Value>
void SetColumn(const std::vector<Value>& column, const Kinds& kinds, std::uint8_t flag,
               Value LoopCandidate::*member, Candidates* candidates, const ByteReader& in) {
  std::size_t next = 0;
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if ((kinds[i] & flag) == 0) continue;
    if (next == column.size()) in.Fail("a column is too short");
    (*candidates)[i].*member = column[next++];
  }
  if (next != column.size()) in.Fail("a column is too long");
}

/// `last` plus the difference that comes next.
int GetNext(int last, ByteReader* in) {
  const std::int64_t difference = in->GetSigned();
  constexpr std::int64_t kLargest = std::numeric_limits<int>::max();
  if (difference < -last || difference > kLargest - last) in->Fail("a number is too large");
  return static_cast<int>(last + difference);
}

Kinds PutIds(const Candidates& candidates, ByteWriter* out) {
  Kinds kinds;
  LoopCandidate last;
  for (const LoopCandidate& candidate : candidates) {
    kinds.push_back(KindOf(candidate));
    out->PutByte(kinds.back());
    out->PutSigned(candidate.submap.index - last.submap.index);
    out->PutSigned(candidate.node.index - last.node.index);
    out->PutSigned(candidate.considered_step - last.considered_step);
    last = candidate;
  }
  return kinds;
}

/// Sets ids, steps and verdicts, and returns the kinds.
Kinds GetIds(int step, Candidates* candidates, ByteReader* in) {
  Kinds kinds;
  LoopCandidate last;
  for (LoopCandidate& candidate : *candidates) {
    const std::uint8_t kind = in->GetByte();
    const auto verdict = static_cast<Verdict>(kind & kVerdictMask);
    if (std::find(kRecordedVerdicts.begin(), kRecordedVerdicts.end(), verdict) ==
        kRecordedVerdicts.end()) {
      in->Fail("no such verdict");
    }
    kinds.push_back(kind);
    candidate.submap.index = GetNext(last.submap.index, in);
    candidate.node.index = GetNext(last.node.index, in);
    candidate.considered_step = GetNext(last.considered_step, in);
    candidate.applied_step = step;
    candidate.verdict = verdict;
    candidate.whole_submap = (kind & kWholeSubmap) != 0;
    candidate.last_look = (kind & kLastLook) != 0;
    last = candidate;
  }
  return kinds;
}

}  // namespace

void PutCandidates(const std::vector<LoopCandidate>& candidates, ByteWriter* out) {
  out->PutUnsigned(candidates.size());
  const Kinds kinds = PutIds(candidates, out);
  const auto searched = [&](auto member) { return Column(candidates, kinds, kHasSearch, member); };
  const auto refined = [&](auto member) {
    return Column(candidates, kinds, kHasRefinedPose, member);
  };
  for (const int supporters : searched(&LoopCandidate::num_supporters)) out->PutSigned(supporters);
  for (const auto number : kNumbers) PutDoubles(searched(number), {}, out);
  const std::vector<Pose2> guesses = searched(&LoopCandidate::submap_from_node_guess);
  PutPoses(guesses, {}, out);
  PutPoses(searched(&LoopCandidate::submap_from_node_searched), guesses, out);
  PutPoses(refined(&LoopCandidate::submap_from_node),
           refined(&LoopCandidate::submap_from_node_searched), out);
}

std::vector<LoopCandidate> GetCandidates(int step, std::size_t max_count, ByteReader* in) {
  const std::size_t count = in->GetCount(kMinBytesPerCandidate);
  if (count > max_count) in->Fail("more loop candidates than the nodes and submaps allow");
  Candidates candidates(count);
  const Kinds kinds = GetIds(step, &candidates, in);
  const auto set = [&](const auto& column, std::uint8_t flag, auto member) {
    SetColumn(column, kinds, flag, member, &candidates, *in);
  };
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    if ((kinds[i] & kHasSearch) != 0) candidates[i].num_supporters = GetNext(0, in);
  }
  for (const auto number : kNumbers) set(GetDoubles({}, in), kHasSearch, number);
  const std::vector<Pose2> guesses = GetPoses({}, in);
  set(guesses, kHasSearch, &LoopCandidate::submap_from_node_guess);
  set(GetPoses(guesses, in), kHasSearch, &LoopCandidate::submap_from_node_searched);
  set(GetPoses(
          Column(candidates, kinds, kHasRefinedPose, &LoopCandidate::submap_from_node_searched),
          in),
      kHasRefinedPose, &LoopCandidate::submap_from_node);
  return candidates;
}

}  // namespace loopscope
