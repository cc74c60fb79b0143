// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/cli/evaluation_report.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/text_table.h"

namespace loopscope {
namespace {

const double kDegrees = RadiansToDegrees(1.0);

/// One number of the result, with the name it has in CSV and JSON.
struct Figure {
  std::string name;
  double value;
};
using Figures = std::vector<Figure>;

/// What evo prints of a sample of errors, in another unit.
void AddEvoStatistics(const std::string& name, const std::string& unit, const Statistics& errors,
                      double factor, Figures* figures) {
  for (const auto& [statistic, value] :
       {std::pair("rmse", errors.rmse), std::pair("mean", errors.mean),
        std::pair("median", errors.median), std::pair("std", PopulationDeviation(errors)),
        std::pair("min", errors.min), std::pair("max", errors.max)}) {
    figures->push_back({name + "_" + statistic + "_" + unit, factor * value});
  }
}

void AddFigures(const RelationsError& error, Figures* figures) {
  const double square = kDegrees * kDegrees;
  for (const Figure& figure :
       Figures{{"relations", static_cast<double>(error.translation.count)},
               {"translation_mean_m", error.translation.mean},
               {"translation_std_m", error.translation.standard_deviation},
               {"translation_max_m", error.translation.max},
               {"squared_translation_mean_m2", error.translation_squared.mean},
               {"squared_translation_std_m2", error.translation_squared.standard_deviation},
               {"displacement_mean_m", error.translation_apart.mean},
               {"displacement_std_m", error.translation_apart.standard_deviation},
               {"rotation_mean_deg", kDegrees * error.rotation.mean},
               {"rotation_std_deg", kDegrees * error.rotation.standard_deviation},
               {"rotation_max_deg", kDegrees * error.rotation.max},
               {"squared_rotation_mean_deg2", square * error.rotation_squared.mean},
               {"squared_rotation_std_deg2", square * error.rotation_squared.standard_deviation}}) {
    figures->push_back(figure);
  }
}

void AddFigures(const TrajectoryError& error, Figures* figures) {
  figures->push_back({"poses", static_cast<double>(error.translation.count)});
  AddEvoStatistics("ate", "m", error.translation, 1.0, figures);
  AddEvoStatistics("ate_rotation", "deg", error.rotation, kDegrees, figures);
}

void AddFigures(const RelativeError& error, Figures* figures) {
  figures->push_back({"rpe_pairs", static_cast<double>(error.translation.count)});
  AddEvoStatistics("rpe", "m", error.translation, 1.0, figures);
  AddEvoStatistics("rpe_rotation", "deg", error.rotation, kDegrees, figures);
}

void AddShare(const std::string& name, double part, double whole, Figures* figures) {
  if (whole > 0.0) figures->push_back({name, part / whole});
}

int NumFalseByTheirScans(const LoopEvaluation& loops) {
  return static_cast<int>(
      std::count_if(loops.false_loops.begin(), loops.false_loops.end(),
                    [](const FalseLoop& loop) { return loop.FitsBetterInReference(); }));
}

void AddFigures(const LoopEvaluation& loops, Figures* figures) {
  const LoopCounts& counts = loops.counts;
  const auto num_closed = loops.num_revisits - static_cast<double>(loops.missed.size());
  figures->push_back({"loops", static_cast<double>(counts.all)});
  figures->push_back({"loops_in_force", static_cast<double>(counts.in_force)});
  AddShare("loops_self_consistent", counts.self_consistent, counts.all, figures);
  AddShare("loop_precision", counts.correct, counts.judged, figures);
  if (counts.judged > 0) {
    figures->push_back({"loops_false", static_cast<double>(loops.false_loops.size())});
    figures->push_back(
        {"loops_false_by_their_scans", static_cast<double>(NumFalseByTheirScans(loops))});
  }
  if (loops.num_revisits > 0) {
    figures->push_back({"revisits", static_cast<double>(loops.num_revisits)});
  }
  AddShare("loop_recall", num_closed, loops.num_revisits, figures);
  AddShare("loop_recall_accepted", loops.num_revisits - loops.num_never_accepted,
           loops.num_revisits, figures);
}

void AddFigures(const MapQuality& map, Figures* figures) {
  figures->push_back({"wall_thickness_m", map.crispness.wall_thickness});
  figures->push_back({"mean_map_entropy_nats", map.crispness.mean_map_entropy});
  figures->push_back({"map_disagreement", map.disagreement});
}

Figures FiguresOf(const Evaluation& evaluation) {
  Figures figures;
  if (evaluation.relations) AddFigures(*evaluation.relations, &figures);
  if (evaluation.trajectory) AddFigures(*evaluation.trajectory, &figures);
  if (evaluation.relative) AddFigures(*evaluation.relative, &figures);
  if (evaluation.loops) AddFigures(*evaluation.loops, &figures);
  if (evaluation.map) AddFigures(*evaluation.map, &figures);
  return figures;
}

std::optional<double> ValueOf(const Figures& figures, const std::string& name) {
  const auto found = std::find_if(figures.begin(), figures.end(),
                                  [&](const Figure& figure) { return figure.name == name; });
  if (found == figures.end()) return std::nullopt;
  return found->value;
}

/// A column of the table: a figure in another unit.
struct Column {
  const char* title;
  const char* figure;
  double factor;
  int precision;
};

constexpr Column kColumns[] = {{"relat. [m]", "translation_mean_m", 1.0, 4},
                               {"+-", "translation_std_m", 1.0, 4},
                               {"[deg]", "rotation_mean_deg", 1.0, 3},
                               {"+-", "rotation_std_deg", 1.0, 3},
                               {"ATE [m]", "ate_rmse_m", 1.0, 3},
                               {"max", "ate_max_m", 1.0, 3},
                               {"RPE [m]", "rpe_rmse_m", 1.0, 3},
                               {"[deg]", "rpe_rotation_rmse_deg", 1.0, 3},
                               {"loops", "loops", 1.0, 0},
                               {"held", "loops_in_force", 1.0, 0},
                               {"self [%]", "loops_self_consistent", 100.0, 1},
                               {"true [%]", "loop_precision", 100.0, 1},
                               {"recall [%]", "loop_recall", 100.0, 1},
                               {"accepted", "loop_recall_accepted", 100.0, 1},
                               {"wall [mm]", "wall_thickness_m", 1000.0, 1},
                               {"entropy", "mean_map_entropy_nats", 1.0, 3},
                               {"disagree [%]", "map_disagreement", 100.0, 1}};

std::string SummaryTable(const std::vector<Evaluation>& evaluations) {
  std::vector<TextRow> rows{{"run"}};
  for (const Column& column : kColumns) rows[0].emplace_back(column.title);
  for (const Evaluation& evaluation : evaluations) {
    const Figures figures = FiguresOf(evaluation);
    TextRow row{evaluation.run};
    for (const Column& column : kColumns) {
      const std::optional<double> value = ValueOf(figures, column.figure);
      row.push_back(value ? fmt::format("{:.{}f}", column.factor * *value, column.precision) : "-");
    }
    rows.push_back(row);
  }
  return AlignedTable(rows);
}

TextRow StatisticsRow(const std::string& name, const Statistics& errors, double factor,
                      double deviation) {
  TextRow row{name, fmt::format("{}", errors.count)};
  for (const double value :
       {errors.rmse, errors.mean, errors.median, deviation, errors.min, errors.max}) {
    row.push_back(fmt::format("{:.4f}", factor * value));
  }
  return row;
}

std::string StatisticsTable(const Evaluation& evaluation) {
  std::vector<TextRow> rows{{"errors", "count", "rmse", "mean", "median", "std", "min", "max"}};
  const auto add = [&](const std::string& name, const Statistics& errors, double factor) {
    rows.push_back(StatisticsRow(name, errors, factor, errors.standard_deviation));
  };
  const auto add_as_evo = [&](const std::string& name, const Statistics& errors, double factor) {
    rows.push_back(StatisticsRow(name, errors, factor, PopulationDeviation(errors)));
  };
  if (const auto& error = evaluation.relations) {
    add("relations: translation [m]", error->translation, 1.0);
    add("squared [m2]", error->translation_squared, 1.0);
    add("displacement alone [m]", error->translation_apart, 1.0);
    add("rotation [deg]", error->rotation, kDegrees);
    add("squared [deg2]", error->rotation_squared, kDegrees * kDegrees);
  }
  if (const auto& error = evaluation.trajectory) {
    add_as_evo("ATE: translation [m]", error->translation, 1.0);
    add_as_evo("rotation [deg]", error->rotation, kDegrees);
  }
  if (const auto& error = evaluation.relative) {
    add_as_evo("RPE: translation [m]", error->translation, 1.0);
    add_as_evo("rotation [deg]", error->rotation, kDegrees);
  }
  return rows.size() > 1 ? "\n" + AlignedTable(rows) : "";
}

double MetersOf(const JudgedLoop& loop) { return loop.error->translation.norm(); }
double DegreesOf(const JudgedLoop& loop) { return kDegrees * std::abs(loop.error->rotation); }

nlohmann::ordered_json ToJson(const FalseLoop& false_loop) {
  const JudgedLoop& loop = false_loop.loop;
  return {{"submap", loop.submap.index},
          {"node", loop.node.index},
          {"error_m", MetersOf(loop)},
          {"error_deg", DegreesOf(loop)},
          {"weight", loop.weight},
          {"score", false_loop.score},
          {"score_in_reference", false_loop.score_in_reference}};
}

nlohmann::ordered_json ToJson(const Revisit& revisit) {
  return {{"first_submap", revisit.first.index},
          {"second_submap", revisit.second.index},
          {"first_node", revisit.first_node.index},
          {"second_node", revisit.second_node.index},
          {"distance_m", revisit.distance}};
}

template <typename Value>
nlohmann::ordered_json ToJson(const std::vector<Value>& values) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Value& value : values) list.push_back(ToJson(value));
  return list;
}

}  // namespace

std::string EvaluationTable(const std::vector<Evaluation>& evaluations) {
  std::string text = SummaryTable(evaluations);
  if (evaluations.size() == 1) text += StatisticsTable(evaluations.front());
  return text;
}

std::string LoopLists(const std::vector<Evaluation>& evaluations) {
  std::string text;
  for (const Evaluation& evaluation : evaluations) {
    if (!evaluation.loops) continue;
    const LoopEvaluation& loops = *evaluation.loops;
    text += fmt::format(
        "\n{}: {} of {} loops judged are false ({} by their scans), {} of {} revisits are missed\n",
        evaluation.run, loops.false_loops.size(), loops.counts.judged, NumFalseByTheirScans(loops),
        loops.missed.size(), loops.num_revisits);
    for (const FalseLoop& false_loop : loops.false_loops) {
      const JudgedLoop& loop = false_loop.loop;
      text += fmt::format(
          "false   submap {}, node {}: off by {:.3f} m, {:.2f} deg; weight {:.2f}; score {:.3f}, "
          "where the reference has it {:.3f}\n",
          ToString(loop.submap), ToString(loop.node), MetersOf(loop), DegreesOf(loop), loop.weight,
          false_loop.score, false_loop.score_in_reference);
    }
    for (const Revisit& revisit : loops.missed) {
      text += fmt::format("missed  submaps {} and {}: nodes {} and {} are {:.2f} m apart\n",
                          ToString(revisit.first), ToString(revisit.second),
                          ToString(revisit.first_node), ToString(revisit.second_node),
                          revisit.distance);
    }
  }
  return text;
}

std::string EvaluationCsv(const std::vector<Evaluation>& evaluations) {
  std::vector<Figures> rows;
  std::vector<std::string> names;
  for (const Evaluation& evaluation : evaluations) {
    rows.push_back(FiguresOf(evaluation));
    for (const Figure& figure : rows.back()) {
      if (std::find(names.begin(), names.end(), figure.name) == names.end()) {
        names.push_back(figure.name);
      }
    }
  }
  std::string text = "run";
  for (const std::string& name : names) text += "," + name;
  text += '\n';
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += CsvField(evaluations[i].run);
    for (const std::string& name : names) {
      const std::optional<double> value = ValueOf(rows[i], name);
      text += value ? fmt::format(",{}", *value) : ",";
    }
    text += '\n';
  }
  return text;
}

std::string EvaluationJson(const std::vector<Evaluation>& evaluations, bool with_loops) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Evaluation& evaluation : evaluations) {
    nlohmann::ordered_json entry = {{"run", evaluation.run}};
    for (const Figure& figure : FiguresOf(evaluation)) entry[figure.name] = figure.value;
    if (with_loops && evaluation.loops) {
      entry["false_loops"] = ToJson(evaluation.loops->false_loops);
      entry["missed_revisits"] = ToJson(evaluation.loops->missed);
    }
    list.push_back(std::move(entry));
  }
  constexpr auto kReplaceNoUtf8 = nlohmann::ordered_json::error_handler_t::replace;
  return list.dump(1, ' ', /*ensure_ascii=*/false, kReplaceNoUtf8) + "\n";  // names of files
}

}  // namespace loopscope
