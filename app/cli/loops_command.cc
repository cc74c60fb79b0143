// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "core/io/recording_file.h"
#include "core/slam/loop_explanation.h"

namespace loopscope {
namespace {

struct LoopsArguments {
  std::string run;
  std::string verdict;
  std::optional<int> node;
  std::optional<int> submap;
  bool json = false;
  bool csv = false;
};

/// A row of the ledger.
struct Row {
  const LoopCandidate* candidate;
  std::optional<Eigen::Vector3d> residual;  ///< [m, m, rad] at the end, if closed
};

bool IsWanted(const LoopCandidate& candidate, const LoopsArguments& arguments) {
  if (arguments.node && candidate.node.index != *arguments.node) return false;
  if (arguments.submap && candidate.submap.index != *arguments.submap) return false;
  if (!arguments.verdict.empty()) return ToString(candidate.verdict) == arguments.verdict;
  return true;
}

std::vector<Row> Ledger(const Recording& recording, const LoopsArguments& arguments) {
  std::vector<Row> rows;
  if (recording.num_steps() == 0) return rows;
  const MapState state = StateAfterStep(recording, recording.num_steps() - 1);
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!IsWanted(candidate, arguments)) continue;
    rows.push_back({&candidate, std::nullopt});
    if (candidate.verdict == Verdict::kAccepted) {
      rows.back().residual = LoopResidual(state, candidate);
    }
  }
  return rows;
}

/// Of the place found, seen from the guess: how far the search moved the node.
Pose2 Moved(const LoopCandidate& c) {
  return c.submap_from_node_guess.Inverse() * c.submap_from_node_searched;
}
double MovedMeters(const LoopCandidate& c) { return Moved(c).translation.norm(); }
double MovedDegrees(const LoopCandidate& c) {
  return RadiansToDegrees(std::abs(NormalizeAngle(Moved(c).rotation)));
}

double ResidualMeters(const Row& row) { return row.residual->head<2>().norm(); }
double ResidualDegrees(const Row& row) { return RadiansToDegrees(std::abs(row.residual->z())); }

void PrintTable(const std::vector<Row>& rows) {
  constexpr char kColumns[] =
      "{:>9} {:>10} {:>6} {:>6}  {:<12} {:>6} {:>6} {:>6} {:>7} {:>7} {:>9} {:>7} {:>5} {:>9} "
      "{:>9}\n";
  fmt::print(kColumns, "submap", "node", "scan", "in at", "verdict", "score", "needed", "bound",
             "win [m]", "[deg]", "moved [m]", "[deg]", "agree", "resid [m]", "[deg]");
  for (const Row& row : rows) {
    const LoopCandidate& c = *row.candidate;
    fmt::print("{:>9} {:>10} {:>6} {:>6}  {:<12}", ToString(c.submap), ToString(c.node),
               c.considered_step, c.applied_step, ToString(c.verdict));
    if (c.verdict != Verdict::kNotSampled) {
      fmt::print(
          " {:>6.3f} {:>6.3f} {:>6.3f} {:>7.2f} {:>7.2f} {:>9} {:>7} {:>5}", c.score, c.min_score,
          c.score_bound, c.linear_search_window, RadiansToDegrees(c.angular_search_window),
          IsFound(c.verdict) ? fmt::format("{:.2f}", MovedMeters(c)) : "",
          IsFound(c.verdict) ? fmt::format("{:.2f}", MovedDegrees(c)) : "", c.num_supporters);
    }
    if (row.residual) fmt::print(" {:>9.3f} {:>9.2f}", ResidualMeters(row), ResidualDegrees(row));
    fmt::print("\n");
  }
}

void PrintCsv(const std::vector<Row>& rows) {
  fmt::print(
      "submap,node,considered_step,applied_step,verdict,score,min_score,score_bound,"
      "linear_window_m,angular_window_deg,moved_m,moved_deg,supporters,residual_m,residual_deg\n");
  for (const Row& row : rows) {
    const LoopCandidate& c = *row.candidate;
    fmt::print("{},{},{},{},{},", c.submap.index, c.node.index, c.considered_step, c.applied_step,
               ToString(c.verdict));
    if (c.verdict == Verdict::kNotSampled) {
      fmt::print(",,,,,,,,");
    } else {
      fmt::print("{},{},{},{},{},{},{},", c.score, c.min_score, c.score_bound,
                 c.linear_search_window, RadiansToDegrees(c.angular_search_window),
                 IsFound(c.verdict) ? fmt::format("{},{}", MovedMeters(c), MovedDegrees(c)) : ",",
                 c.num_supporters);
    }
    if (row.residual) {
      fmt::print("{},{}\n", ResidualMeters(row), ResidualDegrees(row));
    } else {
      fmt::print(",\n");
    }
  }
}

void PrintJson(const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    const LoopCandidate& c = *row.candidate;
    nlohmann::ordered_json entry = {{"submap", c.submap.index},
                                    {"node", c.node.index},
                                    {"considered_step", c.considered_step},
                                    {"applied_step", c.applied_step},
                                    {"verdict", ToString(c.verdict)}};
    if (c.verdict != Verdict::kNotSampled) {
      entry["score"] = c.score;
      entry["min_score"] = c.min_score;
      entry["score_bound"] = c.score_bound;
      entry["linear_window_m"] = c.linear_search_window;
      entry["angular_window_deg"] = RadiansToDegrees(c.angular_search_window);
      if (IsFound(c.verdict)) {
        entry["moved_m"] = MovedMeters(c);
        entry["moved_deg"] = MovedDegrees(c);
      }
      entry["supporters"] = c.num_supporters;
    }
    if (row.residual) {
      entry["residual_m"] = ResidualMeters(row);
      entry["residual_deg"] = ResidualDegrees(row);
    }
    list.push_back(std::move(entry));
  }
  std::cout << list.dump(1) << "\n";
}

int RunLoops(const LoopsArguments& arguments) {
  const Recording recording = ReadRecording(arguments.run);
  if (arguments.node) NodeOf(recording, *arguments.node);
  if (arguments.submap) SubmapOf(recording, *arguments.submap);
  const std::vector<Row> rows = Ledger(recording, arguments);
  if (arguments.json) {
    PrintJson(rows);
  } else if (arguments.csv) {
    PrintCsv(rows);
  } else {
    PrintTable(rows);
  }
  return 0;
}

constexpr char kColumns[] =
    "Columns: scan: after which the pair came up. in at: the scan after which the result entered "
    "the\n"
    "graph. needed: the score to beat. bound: no pose in the window scores more. win, [deg]: half "
    "the\n"
    "window, each way from where the map had the node. moved, [deg]: from there to where the "
    "search\n"
    "found it. agree: other nodes with loops that say the same. resid, [deg]: of eq. 5, at the "
    "end.";

std::vector<std::string> NamesOfVerdicts() {
  std::vector<std::string> names;
  for (const Verdict verdict : kRecordedVerdicts) names.push_back(ToString(verdict));
  return names;
}

}  // namespace

void AddLoopsCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "loops", "List every pair of node and submap that came up for a loop, and what became of it");
  command->footer(kColumns);
  const auto arguments = std::make_shared<LoopsArguments>();
  AddRunArgument(command, &arguments->run);
  command->add_option("--verdict", arguments->verdict, "Only pairs with this verdict")
      ->type_name("VERDICT")
      ->check(CLI::IsMember(NamesOfVerdicts()));
  command->add_option("--node", arguments->node, "Only pairs of this node")->type_name("N");
  command->add_option("--submap", arguments->submap, "Only pairs of this submap")->type_name("M");
  CLI::Option* const json = command->add_flag("--json", arguments->json, "Print JSON");
  command->add_flag("--csv", arguments->csv, "Print CSV")->excludes(json);
  command->callback([arguments, exit_code] { *exit_code = RunLoops(*arguments); });
}

}  // namespace loopscope
