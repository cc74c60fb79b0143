// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "core/io/recording_file.h"
#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

struct WhyArguments {
  std::string run;
  int node = 0;
  int submap = 0;
};

void PrintCheck(const LoopCheck& check) {
  const std::string expected =
      check.expected.empty() ? "" : fmt::format(" (expected: {})", check.expected);
  fmt::print("  {} {:<32} {}{}\n", check.passed ? "ok " : "NO ", check.what, check.value, expected);
}

int RunWhy(const WhyArguments& arguments) {
  const Recording recording = ReadRecording(arguments.run);
  const NodeId node = NodeOf(recording, arguments.node);
  const SubmapId submap = SubmapOf(recording, arguments.submap);
  const LoopExplanation explanation = ExplainLoop(recording, submap, node);
  fmt::print("node {}, submap {}\n", ToString(node), ToString(submap));
  std::for_each(explanation.checks.begin(), explanation.checks.end(), PrintCheck);
  fmt::print("{}\n", explanation.answer);
  if (explanation.best_in_window) {
    fmt::print("{}\n", ExplainWholeSubmap(recording, *explanation.best_in_window));
  }
  return explanation.closed ? 0 : 1;
}

}  // namespace

void AddWhyCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "why", "Why was the loop between a node and a submap closed, or not (exit code 1)");
  const auto arguments = std::make_shared<WhyArguments>();
  AddRunArgument(command, &arguments->run);
  command->add_option("--node", arguments->node, "Index of the node")->required()->type_name("N");
  command->add_option("--submap", arguments->submap, "Index of the submap")
      ->required()
      ->type_name("M");
  command->callback([arguments, exit_code] { *exit_code = RunWhy(*arguments); });
}

}  // namespace loopscope
