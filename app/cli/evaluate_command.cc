// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/cli/commands.h"
#include "app/cli/run_arguments.h"
#include "core/evaluation/relations.h"
#include "core/evaluation/trajectory_error.h"
#include "core/io/recording_file.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"
#include "core/slam/trajectories.h"

namespace loopscope {
namespace {

struct EvaluateArguments {
  std::vector<std::string> runs;
  std::string relations;
  std::string reference;
  std::optional<double> max_error;
  bool json = false;
  bool csv = false;
};

/// How far one run is from the truth, as far as was asked for.
struct Evaluation {
  std::string run;
  std::optional<RelationsError> relations;
  std::optional<TrajectoryError> trajectory;
};

Trajectory TrajectoryOf(const std::string& path) {
  if (!IsRecording(path)) return ReadTum(path);
  const Recording recording = ReadRun(path);
  return DenseTrajectory(recording, StateOf(recording, std::nullopt));
}

std::vector<Evaluation> Evaluate(const EvaluateArguments& arguments) {
  std::vector<Relation> relations;
  if (!arguments.relations.empty()) relations = ReadRelations(arguments.relations);
  Trajectory reference;
  if (!arguments.reference.empty()) reference = ReadTum(arguments.reference);
  std::vector<Evaluation> evaluations;
  for (const std::string& run : arguments.runs) {
    const Trajectory trajectory = TrajectoryOf(run);
    Evaluation evaluation{run, std::nullopt, std::nullopt};
    if (!relations.empty()) evaluation.relations = EvaluateRelations(relations, trajectory);
    if (!reference.empty()) {
      evaluation.trajectory = EvaluateTrajectory(reference, trajectory);
      if (!evaluation.trajectory) {
        throw std::invalid_argument(run + ": its times have nothing in common with those of " +
                                    arguments.reference);
      }
    }
    evaluations.push_back(evaluation);
  }
  return evaluations;
}

/// One number of the result, with the name it has in CSV and JSON.
struct Figure {
  std::string name;
  double value;
};

std::vector<Figure> FiguresOf(const RelationsError& error) {
  const double degrees = RadiansToDegrees(1.0);
  return {
      {"relations", static_cast<double>(error.translation.count)},
      {"translation_mean_m", error.translation.mean},
      {"translation_std_m", error.translation.standard_deviation},
      {"translation_max_m", error.translation.max},
      {"squared_translation_mean_m2", error.translation_squared.mean},
      {"squared_translation_std_m2", error.translation_squared.standard_deviation},
      {"rotation_mean_deg", degrees * error.rotation.mean},
      {"rotation_std_deg", degrees * error.rotation.standard_deviation},
      {"rotation_max_deg", degrees * error.rotation.max},
      {"squared_rotation_mean_deg2", degrees * degrees * error.rotation_squared.mean},
      {"squared_rotation_std_deg2", degrees * degrees * error.rotation_squared.standard_deviation}};
}

std::vector<Figure> FiguresOf(const TrajectoryError& error) {
  const double degrees = RadiansToDegrees(1.0);
  return {{"poses", static_cast<double>(error.translation.count)},
          {"ate_rmse_m", error.translation.rmse},
          {"ate_mean_m", error.translation.mean},
          {"ate_median_m", error.translation.median},
          {"ate_std_m", error.translation.standard_deviation},
          {"ate_max_m", error.translation.max},
          {"ate_rotation_mean_deg", degrees * error.rotation.mean},
          {"ate_rotation_max_deg", degrees * error.rotation.max}};
}

std::vector<Figure> FiguresOf(const Evaluation& evaluation) {
  std::vector<Figure> figures;
  if (evaluation.relations) figures = FiguresOf(*evaluation.relations);
  if (evaluation.trajectory) {
    for (const Figure& figure : FiguresOf(*evaluation.trajectory)) figures.push_back(figure);
  }
  return figures;
}

void PrintText(const std::vector<Evaluation>& evaluations) {
  for (const Evaluation& evaluation : evaluations) {
    fmt::print("{}\n", evaluation.run);
    if (const auto& error = evaluation.relations) {
      fmt::print("  {} relations\n", error->translation.count);
      fmt::print(
          "    translation  {:.4f} +- {:.4f} m, at most {:.3f} m; squared {:.5f} +- {:.5f} m2\n",
          error->translation.mean, error->translation.standard_deviation, error->translation.max,
          error->translation_squared.mean, error->translation_squared.standard_deviation);
      const double degrees = RadiansToDegrees(1.0);
      fmt::print(
          "    rotation     {:.3f} +- {:.3f} deg, at most {:.2f} deg; squared {:.3f} +- {:.3f} "
          "deg2\n",
          degrees * error->rotation.mean, degrees * error->rotation.standard_deviation,
          degrees * error->rotation.max, degrees * degrees * error->rotation_squared.mean,
          degrees * degrees * error->rotation_squared.standard_deviation);
    }
    if (const auto& error = evaluation.trajectory) {
      fmt::print("  {} poses of the reference, aligned\n", error->translation.count);
      fmt::print(
          "    translation  rmse {:.4f} m, mean {:.4f} m, median {:.4f} m, at most {:.3f} m\n",
          error->translation.rmse, error->translation.mean, error->translation.median,
          error->translation.max);
      fmt::print("    rotation     mean {:.3f} deg, at most {:.2f} deg\n",
                 RadiansToDegrees(error->rotation.mean), RadiansToDegrees(error->rotation.max));
    }
  }
}

void PrintCsv(const std::vector<Evaluation>& evaluations) {
  fmt::print("run");
  for (const Figure& figure : FiguresOf(evaluations.front())) fmt::print(",{}", figure.name);
  fmt::print("\n");
  for (const Evaluation& evaluation : evaluations) {
    fmt::print("{}", evaluation.run);
    for (const Figure& figure : FiguresOf(evaluation)) fmt::print(",{}", figure.value);
    fmt::print("\n");
  }
}

void PrintJson(const std::vector<Evaluation>& evaluations) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Evaluation& evaluation : evaluations) {
    nlohmann::ordered_json entry = {{"run", evaluation.run}};
    for (const Figure& figure : FiguresOf(evaluation)) entry[figure.name] = figure.value;
    list.push_back(std::move(entry));
  }
  std::cout << list.dump(1) << "\n";
}

bool IsWithin(const Evaluation& evaluation, double max_error) {
  return (!evaluation.relations || evaluation.relations->translation.mean <= max_error) &&
         (!evaluation.trajectory || evaluation.trajectory->translation.rmse <= max_error);
}

int RunEvaluate(const EvaluateArguments& arguments) {
  if (arguments.relations.empty() && arguments.reference.empty()) {
    throw std::invalid_argument("nothing to compare with; expected --relations or --reference");
  }
  const std::vector<Evaluation> evaluations = Evaluate(arguments);
  if (arguments.json) {
    PrintJson(evaluations);
  } else if (arguments.csv) {
    PrintCsv(evaluations);
  } else {
    PrintText(evaluations);
  }
  if (!arguments.max_error) return 0;
  for (const Evaluation& evaluation : evaluations) {
    if (!IsWithin(evaluation, *arguments.max_error)) return 1;
  }
  return 0;
}

}  // namespace

void AddEvaluateCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("evaluate", "Compare runs with what is known of the true way");
  const auto arguments = std::make_shared<EvaluateArguments>();
  command
      ->add_option("RUN", arguments->runs,
                   "Recordings, or trajectories in TUM's format; of a recording the dense one is "
                   "taken, see export")
      ->required()
      ->type_name("");
  command
      ->add_option("--relations", arguments->relations,
                   "Relative poses checked by hand (Kuemmerle et al. 2009), lines "
                   "\"t1 t2 x y z roll pitch yaw\"")
      ->type_name("FILE");
  command
      ->add_option("--reference", arguments->reference,
                   "True trajectory in TUM's format; the run is aligned to it (Umeyama, without "
                   "scale)")
      ->type_name("FILE");
  command
      ->add_option("--max-error", arguments->max_error,
                   "Exit with 1 if the mean translational error of the relations, or the root mean "
                   "square one of the trajectory, is larger")
      ->type_name("METERS");
  CLI::Option* const json = command->add_flag("--json", arguments->json, "Print JSON");
  command->add_flag("--csv", arguments->csv, "Print CSV")->excludes(json);
  command->callback([arguments, exit_code] { *exit_code = RunEvaluate(*arguments); });
}

}  // namespace loopscope
