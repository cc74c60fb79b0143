// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/run_arguments.h"

#include <stdexcept>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

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

NodeId NodeOf(const Recording& recording, int index) {
  CheckIndex("node", index, recording.nodes().size());
  return NodeId{index};
}

SubmapId SubmapOf(const Recording& recording, int index) {
  CheckIndex("submap", index, recording.submaps().size());
  return SubmapId{index};
}

}  // namespace loopscope
