// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_arguments.h"

#include <cmath>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "core/io/file_error.h"
#include "core/io/recording_file.h"
#include "core/io/words.h"

namespace loopscope {
namespace {

void CheckIndex(const char* what, int index, std::size_t size) {
  if (0 <= index && index < static_cast<int>(size)) return;
  throw std::invalid_argument(
      size == 0 ? fmt::format("there is no {} in the recording", what)
                : fmt::format("there is no {0} {1}; expected 0 to {2}", what, index, size - 1));
}

}  // namespace

void AddRunArgument(CLI::App* command, std::string* run) {
  command->add_option("RUN", *run, "Recording, as `loopscope map` writes it")
      ->required()
      ->type_name("");
}

std::string RefuseNan(const std::string& text) {
  const std::optional<double> number = ParseDouble(text);
  return number && !std::isnan(*number) ? "" : "expected a number";
}

Recording ReadRun(const std::string& path) {
  Recording recording = ReadRecording(path);
  if (recording.num_steps() == 0)
    throw FileError(path, "the run was stopped before its first scan");
  return recording;
}

MapState StateOf(const Recording& recording, std::optional<int> step) {
  if (step) CheckIndex("step", *step, static_cast<std::size_t>(recording.num_steps()));
  return StateAfterStep(recording, step.value_or(recording.num_steps() - 1));
}

NodeId NodeOf(const Recording& recording, int index) {
  CheckIndex("node", index, recording.nodes().size());
  return NodeId{index};
}

SubmapId SubmapOf(const Recording& recording, int index) {
  CheckIndex("submap", index, recording.submaps().size());
  return SubmapId{index};
}

}  // namespace loopscope
