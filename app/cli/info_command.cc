// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "core/evaluation/log_report.h"
#include "core/io/carmen_log.h"
#include "core/io/recording_file.h"
#include "core/io/recording_hash.h"
#include "core/slam/loop_explanation.h"
#include "core/slam/option_values.h"

namespace loopscope {
namespace {

struct InfoArguments {
  std::string file;
  bool options = false;
};

template <typename... Values>
void PrintRow(const std::string& name, fmt::format_string<Values...> format, Values&&... values) {
  fmt::print("{:<10} {}\n", name, fmt::format(format, std::forward<Values>(values)...));
}

/// To four decimals: a mount comes from the difference of two poses, and has no more.
double FourDecimals(double value) { return std::round(1e4 * value) / 1e4 + 0.0; }

void PrintScanner(const ScanLog& log) {
  for (const BeamGeometry& beams : log.beam_geometries) {
    PrintRow("beams", "{}, {:g} deg apart, from {:g} deg to {:g} deg", beams.num_beams,
             RadiansToDegrees(beams.angle_increment), RadiansToDegrees(beams.first_angle),
             RadiansToDegrees(beams.Angle(beams.num_beams - 1)));
  }
  const Pose2& mount = log.base_from_laser;
  PrintRow("scanner", "x {:g} m, y {:g} m, turned {:g} deg on the robot", FourDecimals(mount.x()),
           FourDecimals(mount.y()), FourDecimals(RadiansToDegrees(mount.rotation)));
}

void PrintLog(const ScanLog& log) {
  const LogReport report = ReportOn(log);
  PrintRow("log", "{}", log.name);
  PrintRow("scans", "{} in {:.1f} s, one every {:.3g} s", log.scans.size(), report.duration,
           report.scan_period);
  PrintScanner(log);
  PrintRow("readings",
           "{:.1f} % returns (median {:.1f} m, largest {:.1f} m), {:.1f} % nothing came back, "
           "{:.1f} % invalid",
           100.0 * report.share_of_returns, report.median_range, report.largest_range,
           100.0 * report.share_of_nothing, 100.0 * report.share_of_invalid);
  if (log.odometry.empty()) {
    PrintRow("odometry", "none");
  } else {
    PrintRow("odometry", "{} readings, a way of {:.0f} m, {:.2f} m from scan to scan",
             log.odometry.size(), report.odometry_length, report.scan_distance);
  }
  for (const LogNote& note : log.notes) {
    PrintRow("note", "{}x {}, first in line {}", note.count, note.what, note.first_line);
  }
  for (const std::string& advice : report.advice) PrintRow("advice", "{}", advice);
}

std::vector<std::string> LinesOf(const Options& options) {
  std::istringstream text(OptionsToText(options));
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  return lines;
}

/// The lines in which `options` differ from `preset`.
std::vector<std::string> Differences(const Options& options, const Options& preset) {
  const std::vector<std::string> preset_lines = LinesOf(preset);
  std::vector<std::string> differences;
  for (const std::string& line : LinesOf(options)) {
    if (std::find(preset_lines.begin(), preset_lines.end(), line) == preset_lines.end()) {
      differences.push_back(line);
    }
  }
  return differences;
}

void PrintOptions(const Options& options, bool all) {
  const std::vector<std::string> from_ours = Differences(options, LoopscopePreset());
  const std::vector<std::string> from_stock = Differences(options, CartographerPreset());
  const bool is_ours = from_ours.size() <= from_stock.size();
  const std::vector<std::string>& differences = is_ours ? from_ours : from_stock;
  PrintRow("preset", "{}{}", is_ours ? "loopscope" : "cartographer",
           differences.empty() ? "" : ", but for:");
  for (const std::string& line : all ? LinesOf(options) : differences)
    PrintRow("option", "{}", line);
}

/// How many scans were matched where; of what is unusual, at which scan to begin to look.
void PrintMatches(const Recording& recording) {
  std::map<MatchStart, std::vector<int>> steps;
  for (int step = 0; step < recording.num_steps(); ++step) {
    if (const auto start = recording.step(step).match_start) steps[*start].push_back(step);
  }
  for (const auto& [start, found] : steps) {
    const std::string first =
        start == MatchStart::kPrior ? "" : fmt::format(", first at scan {}", found.front());
    PrintRow("matches", "{} {}{}", found.size(), ToString(start), first);
  }
}

void PrintLoops(const std::vector<LoopCandidate>& candidates) {
  for (const std::string& count : VerdictSummary(candidates)) PrintRow("loops", "{}", count);
}

void PrintRecording(const InfoArguments& arguments) {
  const Recording recording = ReadRecording(arguments.file);
  const std::optional<double> seconds = ReadWallSeconds(arguments.file);
  PrintRow("recording", "{}", arguments.file);
  PrintRow("steps", "{} of {} scans, {}", recording.num_steps(), recording.log().scans.size(),
           seconds ? fmt::format("finished in {:.1f} s", *seconds)
                   : "not finished: interrupted, or still running");
  PrintRow("nodes", "{} in {} submaps", recording.nodes().size(), recording.submaps().size());
  PrintMatches(recording);
  PrintLoops(recording.candidates());
  PrintRow("optimized", "{} times", recording.optimizations().size());
  PrintRow("hash", "{:016x}", HashOfRecording(recording));
  PrintOptions(recording.options(), arguments.options);
  PrintLog(recording.log());
}

}  // namespace

void AddInfoCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("info", "Tell what is in a log or a recording, with advice on bad data");
  const auto arguments = std::make_shared<InfoArguments>();
  command->add_option("FILE", arguments->file, "CARMEN log, plain or gzip, or recording")
      ->required()
      ->type_name("");
  command->add_flag("--options", arguments->options,
                    "List all options of a recorded run, not only those that differ from a preset");
  command->callback([arguments, exit_code] {
    if (IsRecording(arguments->file)) {
      PrintRecording(*arguments);
    } else {
      PrintLog(ReadCarmenLog(arguments->file));
    }
    *exit_code = 0;
  });
}

}  // namespace loopscope
