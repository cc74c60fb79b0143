// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "core/io/candidate_codec.h"

#include <cmath>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/io/file_error.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

constexpr int kStep = 70;

LoopCandidate Unsearched(int submap, int node) {
  LoopCandidate candidate;
  candidate.submap = SubmapId{submap};
  candidate.node = NodeId{node};
  candidate.considered_step = 60 - submap;
  candidate.applied_step = kStep;
  return candidate;
}

LoopCandidate BelowMinScore(int submap, int node) {
  LoopCandidate candidate = Unsearched(submap, node);
  candidate.verdict = Verdict::kBelowMinScore;
  candidate.submap_from_node_guess = Pose2(0.1 * node, M_PI, 1.0);
  candidate.submap_from_node_searched = Pose2(0.1 * node + 0.35, M_PI, 1.01);
  candidate.score = 0.1 + 0.2;
  candidate.score_bound = 0.55;
  candidate.min_score = 0.5;
  candidate.linear_search_window = 7.0;
  candidate.angular_search_window = M_PI / 6.0;
  return candidate;
}

LoopCandidate Accepted(int submap, int node) {
  LoopCandidate candidate = BelowMinScore(submap, node);
  candidate.verdict = Verdict::kAccepted;
  candidate.whole_submap = true;
  candidate.last_look = true;
  candidate.num_supporters = 300;
  candidate.rival_score = 0.48;
  candidate.submap_from_node = Pose2(0.0, -0.0, 0.3);
  return candidate;
}

void ExpectEqual(const LoopCandidate& a, const LoopCandidate& b) {
  EXPECT_EQ(a.submap, b.submap);
  EXPECT_EQ(a.node, b.node);
  EXPECT_EQ(a.considered_step, b.considered_step);
  EXPECT_EQ(a.applied_step, b.applied_step);
  EXPECT_EQ(a.whole_submap, b.whole_submap);
  EXPECT_EQ(a.last_look, b.last_look);
  EXPECT_EQ(a.submap_from_node_guess, b.submap_from_node_guess);
  EXPECT_EQ(a.verdict, b.verdict);
  EXPECT_EQ(a.score, b.score);
  EXPECT_EQ(a.min_score, b.min_score);
  EXPECT_EQ(a.rival_score, b.rival_score);
  EXPECT_EQ(a.linear_search_window, b.linear_search_window);
  EXPECT_EQ(a.angular_search_window, b.angular_search_window);
  EXPECT_EQ(a.num_supporters, b.num_supporters);
  EXPECT_EQ(a.score_bound, b.score_bound);
  EXPECT_EQ(a.submap_from_node_searched, b.submap_from_node_searched);
  EXPECT_EQ(a.submap_from_node, b.submap_from_node);
  EXPECT_EQ(std::signbit(a.submap_from_node.y()), std::signbit(b.submap_from_node.y()));
}

std::string Pack(const std::vector<LoopCandidate>& candidates) {
  ByteWriter writer;
  PutCandidates(candidates, &writer);
  return writer.bytes();
}

std::vector<LoopCandidate> Unpack(const std::string& bytes, std::size_t max_count = 100'000) {
  ByteReader reader(bytes, "a.file", "candidates");
  std::vector<LoopCandidate> candidates = GetCandidates(kStep, max_count, &reader);
  reader.ExpectEnd();
  return candidates;
}

TEST(CandidateCodec, CandidatesOfAllKindsComeBackInTheirOrder) {
  LoopCandidate odd = Unsearched(9, 1);
  odd.submap_from_node_guess = Pose2(0.0, -0.0, 0.0);
  LoopCandidate supported = Unsearched(9, 2);
  supported.verdict = Verdict::kInconsistent;
  supported.num_supporters = 1;
  const std::vector<LoopCandidate> candidates = {
      Unsearched(0, 7), BelowMinScore(0, 9), Accepted(1, 3), Unsearched(1, 4), Accepted(0, 3), odd,
      supported};
  const std::vector<LoopCandidate> read = Unpack(Pack(candidates));
  ASSERT_EQ(read.size(), candidates.size());
  for (std::size_t i = 0; i < read.size(); ++i) ExpectEqual(read[i], candidates[i]);
  EXPECT_TRUE(Unpack(Pack({})).empty());
}

TEST(CandidateCodec, APairThatWasNotSearchedTakesFourBytes) {
  std::vector<LoopCandidate> candidates;
  for (int i = 0; i < 1000; ++i) candidates.push_back(Unsearched(3, i));
  EXPECT_LT(Pack(candidates).size(), 4050u);
}

TEST(CandidateCodec, MoreCandidatesThanAllowedAreRefusedUnread) {
  ByteWriter writer;
  writer.PutUnsigned(1001);
  const std::string bytes = writer.bytes() + std::string(4004, '\0');
  EXPECT_THAT(MessageOf([&] { Unpack(bytes, 1000); }),
              testing::HasSubstr("more loop candidates than the nodes and submaps allow"));
}

TEST(CandidateCodec, DamagedBytesThrowOrGiveCandidates) {
  const std::string packed =
      Pack({Unsearched(0, 7), BelowMinScore(0, 9), Accepted(1, 3), Accepted(0, 3)});
  std::mt19937 random(2);
  for (int i = 0; i < 5000; ++i) {
    std::string damaged = packed;
    damaged[random() % damaged.size()] = static_cast<char>(random());
    try {
      EXPECT_LE(Unpack(damaged).size(), damaged.size());
    } catch (const FileError&) {
    }
  }
}

}  // namespace
}  // namespace loopscope
