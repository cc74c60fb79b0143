// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <stdexcept>
#include <string_view>
#include <utility>
#include <vector>

#include "core/io/candidate_codec.h"
#include "core/io/file_error.h"
#include "core/io/number_codec.h"
#include "core/io/recording_check.h"
#include "core/io/step_codec.h"
#include "core/slam/derive.h"
#include "tests/support/small_recording.h"

namespace loopscope {
namespace {

constexpr int kNumSteps = 30;

/// The number of a thing, which may be anything.
int GetIndex(ByteReader* in) { return static_cast<int>(in->GetSigned()); }

Pose2 GetPose(ByteReader* in) {
  const std::vector<Pose2> poses = GetPoses({}, in);
  if (poses.empty()) in->Fail("a pose is missing");
  return poses.front();
}

/// What the tables of a recording may say of a step, as far as their readers let it through.
SlamUpdate GetUpdate(ByteReader* in) {
  enum Parts { kNode = 1, kSubmap = 2, kFinished = 4, kOptimization = 8 };
  SlamUpdate update;
  StepPoseCodec().Get(in, &update.step);
  const int parts = in->GetByte();
  if ((parts & kNode) != 0) {
    update.step.node = NodeId{GetIndex(in)};
    update.node = Node{kNumSteps, GetPose(in), SubmapId{GetIndex(in)}, GetIndex(in)};
  }
  if ((parts & kSubmap) != 0) update.started_submap = Submap{GetPose(in), NodeId{GetIndex(in)}};
  if ((parts & kFinished) != 0) update.finished_submap = SubmapId{GetIndex(in)};
  if ((parts & kOptimization) != 0) {
    update.optimization.emplace();
    update.optimization->step = kNumSteps;
    update.optimization->global_from_submap = GetPoses({}, in);
    update.optimization->global_from_node = GetPoses({}, in);
  }
  update.candidates = GetCandidates(kNumSteps, 1000, in);
  return update;
}

/// What the views and reports derive of the last step.
void Look(const Recording& recording) {
  const MapState state = StateAfterStep(recording, kNumSteps);
  ConstraintsOf(recording, state);
  ReplayMatch(recording, kNumSteps);
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (recording.submap(candidate.submap).finished_step < 0) continue;
    GateOfPair(recording, candidate.submap, candidate.node);
    ConsiderPair(recording, candidate.submap, candidate.node);
  }
}

}  // namespace
}  // namespace loopscope

// Whatever a recording says of its last step: it is refused, or can be looked at.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace loopscope;
  static const Recording steps_before = [] {
    const SmallRun run(kNumSteps + 1);
    Recording recording(run.log(), LoopscopePreset());
    for (int step = 0; step < kNumSteps; ++step) recording.Append(run.updates()[step]);
    return recording;
  }();
  Recording recording = steps_before;
  ByteReader in({reinterpret_cast<const char*>(data), size}, "fuzz.loopscope", "the last step");
  try {
    SlamUpdate update = GetUpdate(&in);
    if (FaultOf(update, recording)) return 0;
    recording.Append(std::move(update));
    Look(recording);
  } catch (const FileError&) {
    return 0;
  } catch (const std::length_error&) {  // a grid that does not fit in memory
    return 0;
  }
  return 0;
}
