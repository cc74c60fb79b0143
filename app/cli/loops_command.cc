// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <functional>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "app/cli/text_table.h"
#include "core/graph/outliers.h"
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
  bool is_held = false;                     ///< at the end, if closed: it is no outlier
};

/// What a column says of a row; nothing where it does not apply.
using Value = std::variant<std::monostate, int, double, bool, std::string, SubmapId, NodeId>;

struct LedgerColumn {
  std::string key;      ///< in JSON and CSV
  std::string heading;  ///< in the table; empty: not there
  int width = 0;        ///< in the table, negative: flush left
  int decimals = 0;     ///< in the table
  Value (*value)(const Row&);
};

Value If(bool applies, Value value) { return applies ? std::move(value) : Value(); }

bool IsSearched(const Row& row) { return row.candidate->verdict != Verdict::kNotSampled; }

template <double LoopCandidate::*number>
Value OfSearch(const Row& row) {
  return If(IsSearched(row), row.candidate->*number);
}

double Degrees(double radians) { return RadiansToDegrees(std::abs(NormalizeAngle(radians))); }

const std::vector<LedgerColumn>& LedgerColumns() {
  static const std::vector<LedgerColumn> columns = {
      {"submap", "submap", 9, 0, [](const Row& row) { return Value(row.candidate->submap); }},
      {"node", "node", 10, 0, [](const Row& row) { return Value(row.candidate->node); }},
      {"considered_step", "scan", 6, 0,
       [](const Row& row) { return Value(row.candidate->considered_step); }},
      {"applied_step", "in at", 6, 0,
       [](const Row& row) { return Value(row.candidate->applied_step); }},
      {"verdict", " verdict", -14, 0,
       [](const Row& row) { return Value(ToString(row.candidate->verdict)); }},
      {"score", "score", 6, 3, OfSearch<&LoopCandidate::score>},
      {"min_score", "needed", 6, 3, OfSearch<&LoopCandidate::min_score>},
      {"score_bound", "bound", 6, 3, OfSearch<&LoopCandidate::score_bound>},
      {"rival_score", "rival", 6, 3,
       [](const Row& row) {
         return If(row.candidate->rival_score > 0.0, row.candidate->rival_score);
       }},
      {"linear_window_m", "win [m]", 7, 2, OfSearch<&LoopCandidate::linear_search_window>},
      {"angular_window_deg", "[deg]", 6, 2,
       [](const Row& row) {
         return If(IsSearched(row), RadiansToDegrees(row.candidate->angular_search_window));
       }},
      {"moved_m", "moved [m]", 9, 2,
       [](const Row& row) {
         return If(IsFound(row.candidate->verdict), Moved(*row.candidate).translation.norm());
       }},
      {"moved_deg", "[deg]", 6, 2,
       [](const Row& row) {
         return If(IsFound(row.candidate->verdict), Degrees(Moved(*row.candidate).rotation));
       }},
      {"supporters", "agree", 5, 0,
       [](const Row& row) { return If(IsSearched(row), row.candidate->num_supporters); }},
      {"residual_m", "resid [m]", 9, 3,
       [](const Row& row) {
         return row.residual ? Value(row.residual->head<2>().norm()) : Value();
       }},
      {"residual_deg", "[deg]", 6, 2,
       [](const Row& row) { return row.residual ? Value(Degrees(row.residual->z())) : Value(); }},
      {"held", "held", 5, 0,
       [](const Row& row) { return row.residual ? Value(row.is_held) : Value(); }},
      {"reason", "", 0, 0, [](const Row& row) { return Value(ReasonOf(*row.candidate)); }},
  };
  return columns;
}

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
  const OutlierOptions& outliers = recording.options().pose_graph.optimization_problem.outliers;
  for (const LoopCandidate& candidate : recording.candidates()) {
    if (!IsWanted(candidate, arguments)) continue;
    Row row{&candidate, std::nullopt};
    if (candidate.verdict == Verdict::kAccepted) {
      row.residual = LoopResidual(state, candidate);
      row.is_held = !IsOutlier(*row.residual, outliers);
    }
    rows.push_back(row);
  }
  return rows;
}

/// Called with each kind of value.
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

std::string TableField(const LedgerColumn& column, const Value& value) {
  return std::visit(
      Overloaded{[](std::monostate) { return std::string(); },
                 [&](double number) { return fmt::format("{:.{}f}", number, column.decimals); },
                 [](bool is) { return std::string(is ? "yes" : "no"); },
                 [](int number) { return fmt::format("{}", number); },
                 [](const std::string& text) { return text; },
                 [](const auto& id) { return ToString(id); }},
      value);
}

void PrintTableLine(const std::function<std::string(const LedgerColumn&)>& field) {
  std::string line;
  for (const LedgerColumn& column : LedgerColumns()) {
    if (column.heading.empty()) continue;
    line += column.width > 0 ? fmt::format("{:>{}} ", field(column), column.width)
                             : fmt::format("{:<{}} ", field(column), -column.width);
  }
  line.erase(line.find_last_not_of(' ') + 1);
  fmt::print("{}\n", line);
}

void PrintTable(const std::vector<Row>& rows) {
  PrintTableLine([](const LedgerColumn& column) { return column.heading; });
  for (const Row& row : rows) {
    PrintTableLine([&](const LedgerColumn& column) {
      const std::string margin = column.width < 0 ? " " : "";
      return margin + TableField(column, column.value(row));
    });
  }
}

std::string CsvFieldOf(const Value& value) {
  return std::visit(Overloaded{[](std::monostate) { return std::string(); },
                               [](SubmapId id) { return fmt::format("{}", id.index); },
                               [](NodeId id) { return fmt::format("{}", id.index); },
                               [](const std::string& text) { return CsvField(text); },
                               [](const auto& other) { return fmt::format("{}", other); }},
                    value);
}

void PrintCsv(const std::vector<Row>& rows) {
  const auto print = [](const auto& field) {
    std::vector<std::string> fields;
    for (const LedgerColumn& column : LedgerColumns()) fields.push_back(field(column));
    fmt::print("{}\n", fmt::join(fields, ","));
  };
  print([](const LedgerColumn& column) { return column.key; });
  for (const Row& row : rows) {
    print([&](const LedgerColumn& column) { return CsvFieldOf(column.value(row)); });
  }
}

void PrintJson(const std::vector<Row>& rows) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Row& row : rows) {
    nlohmann::ordered_json entry;
    for (const LedgerColumn& column : LedgerColumns()) {
      std::visit(
          Overloaded{[](std::monostate) {}, [&](SubmapId id) { entry[column.key] = id.index; },
                     [&](NodeId id) { entry[column.key] = id.index; },
                     [&](const auto& other) { entry[column.key] = other; }},
          column.value(row));
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
    "Columns: scan: after which the pair came up. in at: the scan after which the result\n"
    "entered the graph. needed: the score to beat. bound: no pose in the window scores more.\n"
    "rival: score of a place far from the winner. win, [deg]: half the window, each way from\n"
    "where the map had the node. moved, [deg]: from there to where the search found it. Below\n"
    "score, score and place are the best that was seen before the rest could not win;\n"
    "`loopscope why` finds the best there is. agree: other nodes with loops that say the same.\n"
    "resid, [deg]: of eq. 5, at the end. held: whether the loop still was no outlier then. JSON\n"
    "and CSV have the reason of the verdict, too.";

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
