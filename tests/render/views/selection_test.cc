// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "render/views/selection.h"

#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

using testing::ElementsAre;

LoopCandidate Candidate(int submap, int node, Verdict verdict, double score, int applied_step) {
  LoopCandidate candidate;
  candidate.submap = SubmapId{submap};
  candidate.node = NodeId{node};
  candidate.verdict = verdict;
  candidate.score = score;
  candidate.applied_step = applied_step;
  return candidate;
}

/// step      0    1    2    3    4    5
/// node      0    1    -    2    3    4
/// submap 0  +----+---------+ finished
/// submap 1       +---------+----+ finished
/// submap 2                 +----+----+
Recording SmallRecording() {
  ScanLog log;
  log.name = "small.log";
  for (int i = 0; i < 6; ++i) {
    LaserScan scan;
    scan.time = 100.0 + 0.5 * i;
    log.scans.push_back(scan);
  }
  Recording recording(log, Options());
  int node = 0;
  for (int step = 0; step < 6; ++step) {
    SlamUpdate update;
    if (step != 2) {
      if (step == 0 || step == 1 || step == 3) update.started_submap = Submap{Pose2(), {node}};
      const int first_submap = step < 4 ? 0 : step - 3;
      const int num_submaps = step == 0 ? 1 : 3 - std::max(step - 3, 0);
      update.step.node = NodeId{node};
      update.node = Node{step, Pose2(), SubmapId{first_submap}, std::min(num_submaps, 2)};
      ++node;
    }
    if (step == 3) update.finished_submap = SubmapId{0};
    if (step == 4) {
      update.finished_submap = SubmapId{1};
      update.candidates = {Candidate(0, 3, Verdict::kBelowMinScore, 0.9, 4),
                           Candidate(0, 3, Verdict::kNotSampled, 0.0, 4),
                           Candidate(0, 2, Verdict::kAccepted, 0.6, 4)};
    }
    if (step == 5) update.candidates = {Candidate(1, 4, Verdict::kAccepted, 0.7, 5)};
    recording.Append(update);
  }
  return recording;
}

ViewRequest At(int step) {
  ViewRequest request;
  request.step = step;
  return request;
}

ViewRequest OfNode(int node) {
  ViewRequest request;
  request.node = NodeId{node};
  return request;
}

ViewRequest OfSubmap(int submap) {
  ViewRequest request;
  request.submap = SubmapId{submap};
  return request;
}

TEST(StepOfTest, IsTheLastOneUnlessAStepOrTheUpdateOrMatchOfANodeIsAskedFor) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(StepOf(recording, ViewRequest()), 5);
  EXPECT_EQ(StepOf(recording, At(2)), 2);
  ViewRequest of_node = OfNode(2);
  for (const ViewKind view : {ViewKind::kUpdate, ViewKind::kMatch}) {
    of_node.view = view;
    EXPECT_EQ(StepOf(recording, of_node), 3);
  }
  for (const ViewKind view : {ViewKind::kMap, ViewKind::kGraph, ViewKind::kSubmap}) {
    of_node.view = view;
    EXPECT_EQ(StepOf(recording, of_node), 5);
  }
  ViewRequest both = OfNode(2);
  both.view = ViewKind::kUpdate;
  both.step = 4;
  EXPECT_EQ(StepOf(recording, both), 4);
}

TEST(StepOfTest, RefusesWhatTheRecordingDoesNotHave) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(MessageOf([&] { StepOf(recording, At(6)); }), "no step 6: expected 0 to 5");
  EXPECT_EQ(MessageOf([&] { StepOf(recording, At(-1)); }), "no step -1: expected 0 to 5");
  ViewRequest of_node = OfNode(9);
  of_node.view = ViewKind::kUpdate;
  EXPECT_EQ(MessageOf([&] { StepOf(recording, of_node); }), "no node 9: expected 0 to 4");
  const Recording empty{ScanLog(), Options()};
  EXPECT_EQ(MessageOf([&] { StepOf(empty, ViewRequest()); }),
            "nothing to draw: the recording has no steps");
}

TEST(NodeOfTest, IsTheLastOneInsertedUntilTheStep) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(NodeOf(recording, ViewRequest()), NodeId{4});
  EXPECT_EQ(NodeOf(recording, At(2)), NodeId{1});
  EXPECT_EQ(NodeOf(recording, At(3)), NodeId{2});
  EXPECT_EQ(NodeOf(recording, OfNode(1)), NodeId{1});
}

TEST(SubmapOfTest, IsTheLastOneFinishedUntilTheStep) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(SubmapOf(recording, ViewRequest()), SubmapId{1});
  EXPECT_EQ(SubmapOf(recording, At(3)), SubmapId{0});
  EXPECT_EQ(SubmapOf(recording, OfSubmap(2)), SubmapId{2});
}

TEST(SubmapOfTest, IsTheLastOneBegunWhileNoneIsFinished) {
  EXPECT_EQ(SubmapOf(SmallRecording(), At(2)), SubmapId{1});
}

TEST(SubmapOfTest, RefusesASubmapThatHasNotBegun) {
  ViewRequest request = OfSubmap(2);
  request.step = 2;
  EXPECT_EQ(MessageOf([&] { SubmapOf(SmallRecording(), request); }),
            "submap 2 was begun at step 3: expected that step or a later one");
  EXPECT_EQ(MessageOf([&] { SubmapOf(SmallRecording(), OfSubmap(3)); }),
            "no submap 3: expected 0 to 2");
}

TEST(SubmapOfNodeTest, IsTheOlderOneUnlessTheOtherIsAskedFor) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(SubmapOfNode(recording, ViewRequest(), NodeId{1}), SubmapId{0});
  EXPECT_EQ(SubmapOfNode(recording, OfSubmap(1), NodeId{1}), SubmapId{1});
  EXPECT_EQ(MessageOf([&] { SubmapOfNode(recording, OfSubmap(2), NodeId{1}); }),
            "node 1 is not in submap 2: expected one of submaps 0 to 1");
}

TEST(SearchedPairTest, IsTheAcceptedOneWithTheHighestScore) {
  EXPECT_EQ(SearchedPairOf(SmallRecording(), ViewRequest()), std::pair(SubmapId{1}, NodeId{4}));
}

TEST(SearchedPairTest, KnowsOnlyWhatHadBeenAppliedUntilTheStep) {
  EXPECT_EQ(SearchedPairOf(SmallRecording(), At(4)), std::pair(SubmapId{0}, NodeId{2}));
}

TEST(SearchedPairTest, FitsTheNodeOrTheSubmapThatIsAskedFor) {
  const Recording recording = SmallRecording();
  EXPECT_EQ(SearchedPairOf(recording, OfSubmap(0)), std::pair(SubmapId{0}, NodeId{2}));
  EXPECT_EQ(SearchedPairOf(recording, OfNode(3)), std::pair(SubmapId{0}, NodeId{3}));
  ViewRequest both = OfNode(0);
  both.submap = SubmapId{1};
  EXPECT_EQ(SearchedPairOf(recording, both), std::pair(SubmapId{1}, NodeId{0}));
}

TEST(SearchedPairTest, SaysWhatToAskForWhereNothingWasSearched) {
  EXPECT_EQ(MessageOf([&] { SearchedPairOf(SmallRecording(), At(3)); }),
            "no loop search until step 3: expected both a node and a submap");
  EXPECT_EQ(MessageOf([&] { SearchedPairOf(SmallRecording(), OfNode(1)); }),
            "no loop search of node 1 until step 5: expected both a node and a submap");
}

TEST(SubtitleTest, NamesRunStepIdsAndTime) {
  EXPECT_THAT(Subtitle(SmallRecording(), 3, {"node (0, 2)"}),
              ElementsAre("small.log", "step 3 of 5", "node (0, 2)", "1.5 s"));
}

}  // namespace
}  // namespace loopscope
