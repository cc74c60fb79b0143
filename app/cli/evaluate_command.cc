// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/evaluation.h"
#include "app/cli/evaluation_report.h"
#include "app/cli/picture_arguments.h"
#include "app/cli/run_arguments.h"
#include "app/cli/run_errors.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"
#include "render/picture_format.h"

namespace loopscope {
namespace {

struct EvaluateArguments {
  std::vector<std::string> runs;
  std::string relations;
  std::string reference;
  double delta = 1.0;
  std::string delta_unit = "m";
  std::pair<double, double> loop_tolerance = {kReferenceTolerance.translation,
                                              RadiansToDegrees(kReferenceTolerance.rotation)};
  std::optional<double> max_error;
  std::string plot;
  PictureArguments picture;
  bool loops = false;
  bool json = false;
  bool csv = false;
};

RelativeErrorDelta DeltaOf(const EvaluateArguments& arguments) {
  const double delta = arguments.delta;
  const bool in_frames = arguments.delta_unit == "f";
  const bool is_count = std::floor(delta) == delta && delta <= std::numeric_limits<int>::max();
  if (!(delta > 0.0) || (in_frames && !is_count)) {
    throw std::invalid_argument(fmt::format(
        "--delta {}: expected metres above 0, or a number of frames with --delta-unit f", delta));
  }
  if (in_frames) return DeltaInPoses{static_cast<int>(delta)};
  return DeltaInMeters{delta};
}

LoopTolerance LoopToleranceOf(const EvaluateArguments& arguments) {
  const auto [meters, degrees] = arguments.loop_tolerance;
  if (!(meters >= 0.0) || !(degrees >= 0.0)) {
    throw std::invalid_argument(fmt::format(
        "--loop-tolerance {} {}: expected metres and degrees of 0 or more", meters, degrees));
  }
  return {meters, DegreesToRadians(degrees)};
}

Truth ReadTruth(const EvaluateArguments& arguments) {
  Truth truth;
  if (!arguments.relations.empty()) truth.relations = ReadRelations(arguments.relations);
  if (!arguments.reference.empty()) truth.reference = ReadTum(arguments.reference);
  truth.delta = DeltaOf(arguments);
  truth.loop_tolerance = LoopToleranceOf(arguments);
  return truth;
}

void Print(const std::vector<Evaluation>& evaluations, const EvaluateArguments& arguments) {
  if (arguments.json) {
    fmt::print("{}", EvaluationJson(evaluations, arguments.loops));
  } else if (arguments.csv) {
    fmt::print("{}", EvaluationCsv(evaluations));
  } else {
    fmt::print("{}", EvaluationTable(evaluations));
    if (arguments.loops) fmt::print("{}", LoopLists(evaluations));
  }
}

bool IsWithin(const Evaluation& evaluation, double max_error) {
  return (!evaluation.relations || evaluation.relations->translation.mean <= max_error) &&
         (!evaluation.trajectory || evaluation.trajectory->translation.rmse <= max_error);
}

/// Whether all of its log was mapped; says so if not.
bool IsWhole(const EvaluatedRun& run) {
  if (!run.recording) return true;
  const std::size_t num_scans = run.recording->log().scans.size();
  const auto num_mapped = static_cast<std::size_t>(run.recording->num_steps());
  if (num_mapped == num_scans) return true;
  fmt::print(stderr, "loopscope: {}: {} of {} scans are mapped; --max-error expects all\n",
             run.path, num_mapped, num_scans);
  return false;
}

void RequireOneRunToPlot(const EvaluateArguments& arguments) {
  PictureFormatOf(arguments.plot);  // before the work begins
  if (arguments.runs.size() == 1) return;
  throw std::invalid_argument(
      fmt::format("--plot draws one run, not {}; expected a single RUN", arguments.runs.size()));
}

void Plot(const EvaluatedRun& run, const Truth& truth, const EvaluateArguments& arguments) {
  ViewRequest request;
  ApplyTo(arguments.picture, &request);
  DrawScene(BuildErrorView(RunErrorsOf(run, truth), request, OversamplingOf(request)),
            BackendFromName(arguments.picture.backend), arguments.plot);
}

int RunEvaluate(const EvaluateArguments& arguments) {
  if (!arguments.plot.empty()) RequireOneRunToPlot(arguments);
  const Truth truth = ReadTruth(arguments);
  if (arguments.max_error && truth.empty()) {
    throw std::invalid_argument(
        "nothing to compare with for --max-error; expected --relations or --reference");
  }
  std::vector<Evaluation> evaluations;
  bool are_good = true;
  for (const std::string& path : arguments.runs) {
    const EvaluatedRun run = LoadRun(path);
    evaluations.push_back(Evaluate(run, truth));
    if (arguments.max_error) {
      are_good &= IsWhole(run) && IsWithin(evaluations.back(), *arguments.max_error);
    }
    if (!arguments.plot.empty()) Plot(run, truth, arguments);
  }
  Print(evaluations, arguments);
  return are_good ? 0 : 1;
}

constexpr char kColumns[] =
    "Columns: relat., [deg]: mean errors of the relations. ATE, RPE: root mean squares. loops: "
    "INTER\n"
    "constraints; held: those that the final optimization does not leave out as outliers. self:\n"
    "loops within 20 cm and 1 deg of the optimized poses. true: of those held, within\n"
    "--loop-tolerance of the reference. recall: of the pairs of submaps that the reference puts\n"
    "closer than 3 m, and that see the same, those tied by a loop that is held and not false;\n"
    "accepted: by any that is not false. --loops tells of a false loop how well its scan fits\n"
    "near to where the loop has it, and where the reference has it. If it fits better there, the\n"
    "loop is false by its scan, too; else the submap is bent, or the reference is wrong.\n"
    "wall, entropy: how thick walls are, and how blurred. disagree: what scans that see occupied\n"
    "cells as free have of all that see these. '-': does not apply.";

void AddTruth(CLI::App* command, EvaluateArguments* arguments) {
  command
      ->add_option("--relations", arguments->relations,
                   "Relative poses checked by hand (Kuemmerle et al. 2009), lines "
                   "\"t1 t2 x y z roll pitch yaw\"")
      ->type_name("FILE");
  command
      ->add_option("--reference", arguments->reference,
                   "True trajectory in TUM's format; the run is interpolated at its times, and "
                   "for the ATE aligned to it (Umeyama, without scale)")
      ->type_name("FILE");
  command
      ->add_option("--delta", arguments->delta,
                   "What lies between the poses that the RPE compares (default: 1)")
      ->type_name("LENGTH");
  command
      ->add_option("--delta-unit", arguments->delta_unit,
                   "Its unit: m, metres of the way (the default), or f, frames of the reference")
      ->type_name("UNIT")
      ->check(CLI::IsMember({"m", "f"}));
  command
      ->add_option("--loop-tolerance", arguments->loop_tolerance,
                   "Metres and degrees by which a true loop may disagree with the reference "
                   "(default: 0.5 5, for references that another mapper made)")
      ->type_name("M DEG");
  command
      ->add_option("--max-error", arguments->max_error,
                   "Exit with 1 if the mean translational error of the relations, or the root mean "
                   "square one of the trajectory, is larger")
      ->check(RefuseNan)
      ->check(CLI::NonNegativeNumber)
      ->type_name("METERS");
}

}  // namespace

void AddEvaluateCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "evaluate", "How good runs are: against what is known of the true way, and by themselves");
  command->footer(kColumns);
  const auto arguments = std::make_shared<EvaluateArguments>();
  command
      ->add_option("RUN", arguments->runs,
                   "Recordings, or trajectories in TUM's format; of a recording the dense one is "
                   "taken, see export")
      ->required()
      ->type_name("");
  AddTruth(command, arguments.get());
  command->add_flag("--loops", arguments->loops,
                    "List the loops that the reference says are false, and those that are missed");
  command
      ->add_option("--plot", arguments->plot,
                   "Draw the way in the colours of its errors, and their histograms: a PNG, SVG or "
                   "PDF")
      ->type_name("FILE");
  AddPictureArguments(command, &arguments->picture);
  CLI::Option* const json = command->add_flag("--json", arguments->json, "Print JSON");
  command->add_flag("--csv", arguments->csv, "Print CSV")->excludes(json);
  command->callback([arguments, exit_code] { *exit_code = RunEvaluate(*arguments); });
}

}  // namespace loopscope
