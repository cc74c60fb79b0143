// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/options_arguments.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

std::string CartographerText(const std::string& key) {
  Options options = CartographerPreset();
  for (const OptionRow& row : OptionTable(&options)) {
    if (row.key == key) return ToText(GetValue(row));
  }
  return "";
}

// What is printed is an options file.
int RunOptions(const OptionsArguments& arguments) {
  Options options = ToOptions(arguments);
  for (const OptionRow& row : OptionTable(&options)) {
    const std::string value = ToText(GetValue(row));
    const std::string stock = CartographerText(row.key);
    fmt::print("# {} Expected: {}.{}\n{} = {}\n\n", row.sentence, ExpectedValue(row),
               stock == value ? "" : " Cartographer: " + stock + ".", row.key, value);
  }
  return 0;
}

}  // namespace

void AddOptionsCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "options", "Print all options of a run with what they do, as a file for --options");
  const auto arguments = std::make_shared<OptionsArguments>();
  AddOptionsArguments(command, arguments.get());
  command->callback([arguments, exit_code] { *exit_code = RunOptions(*arguments); });
}

}  // namespace loopscope
