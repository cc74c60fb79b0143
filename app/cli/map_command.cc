// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/map_to_file.h"
#include "app/cli/options_arguments.h"
#include "core/io/carmen_log.h"
#include "core/io/log_stem.h"
#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

struct MapArguments {
  std::string log;
  std::string output;
  OptionsArguments options;
  int num_threads = DefaultNumThreads();
};

/// RUN.loopscope in the current folder for a/b/RUN.log.gz.
std::string DefaultOutput(const std::string& log_path) {
  return LogStem(std::filesystem::path(log_path).filename().string()) + ".loopscope";
}

void PrintNotes(const ScanLog& log) {
  for (const LogNote& note : log.notes) {
    fmt::print(stderr, "{}: {}x {}, first in line {}\n", log.name, note.count, note.what,
               note.first_line);
  }
}

void PrintSummary(const Recording& recording, const std::string& output, double seconds) {
  const auto& scans = recording.log().scans;
  const int num_steps = recording.num_steps();
  const double log_seconds = num_steps > 0 ? scans[num_steps - 1].time - scans[0].time : 0.0;
  fmt::print("{}: {} of {} scans, {} nodes, {} submaps\n", output, num_steps, scans.size(),
             recording.nodes().size(), recording.submaps().size());
  fmt::print("loops: {}\n", fmt::join(VerdictSummary(recording.candidates()), ", "));
  fmt::print("{:.1f} s for {:.0f} s of log: {:.0f} times real time, {:.0f} scans/s\n", seconds,
             log_seconds, log_seconds / seconds, num_steps / seconds);
}

int RunMap(const MapArguments& arguments) {
  const Options options = ToOptions(arguments.options);
  const ScanLog log = ReadCarmenLog(arguments.log);
  PrintNotes(log);
  const std::string output =
      arguments.output.empty() ? DefaultOutput(arguments.log) : arguments.output;
  const MappedFile mapped = MapToFile(log, options, arguments.num_threads, output);
  PrintSummary(mapped.recording, output, mapped.seconds);
  return mapped.was_interrupted ? 1 : 0;
}

}  // namespace

void AddMapCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand("map", "Map a log, and record how");
  const auto arguments = std::make_shared<MapArguments>();
  command->add_option("LOG", arguments->log, "CARMEN log, plain or gzip")
      ->required()
      ->type_name("");
  command
      ->add_option(
          "-o,--output", arguments->output,
          "Recording to write (default: name of the log with .loopscope, here); one that is "
          "finished there is kept, with .before behind its name, until this one is, too")
      ->type_name("RUN.loopscope");
  AddOptionsArguments(command, &arguments->options);
  command
      ->add_option("--threads", arguments->num_threads,
                   "Loop searches at once; the result does not depend on it (default: all cores)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->callback([arguments, exit_code] { *exit_code = RunMap(*arguments); });
}

}  // namespace loopscope
