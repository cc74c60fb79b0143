// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/map_to_file.h"
#include "app/cli/run_arguments.h"
#include "core/evaluation/relations.h"
#include "core/evaluation/trajectory_error.h"
#include "core/io/carmen_log.h"
#include "core/io/file_error.h"
#include "core/io/graph_export.h"
#include "core/io/map_export.h"
#include "core/io/relations_file.h"
#include "core/io/tum_file.h"
#include "core/slam/trajectories.h"
#include "render/headless/painter.h"

namespace loopscope {
namespace {

namespace fs = std::filesystem;

struct DemoArguments {
  std::string folder = "demo";
};

/// The truth that stands beside the bundled log: office.relations, office.tum.
std::string BesideLog(const std::string& extension) {
  return fs::path(LOOPSCOPE_DEMO_LOG).replace_extension().replace_extension(extension).string();
}

void MakeFolder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw FileError(folder, "cannot be made: " + error.message());
}

void Tell(const std::string& path, const std::string& what) {
  fmt::print("  {:<32} {}\n", path, what);
}

void Export(const Recording& recording, const std::string& folder) {
  const MapState state = StateOf(recording, std::nullopt);
  const MapFiles map =
      ExportMap(BuildOccupancyMap(recording, state), MapPixels::kTrinary, folder + "/map");
  Tell(map.image, "occupancy grid for ROS' map_server");
  Tell(map.yaml, "and where it lies");
  WriteTum(folder + "/trajectory.tum", DenseTrajectory(recording, state));
  Tell(folder + "/trajectory.tum", "where the robot was at every stamp");
  ExportGraph(recording, state, folder + "/graph.g2o");
  Tell(folder + "/graph.g2o", "pose graph for g2o");
}

struct DemoPicture {
  ViewKind view;
  std::string what;
};

/// The scan that was matched farthest from where it was predicted.
int StepMovedMost(const Recording& recording) {
  int found = 0;
  double most = 0.0;
  for (int i = 0; i < recording.num_steps(); ++i) {
    const Step& step = recording.step(i);
    const double moved =
        (step.local_from_base.translation - step.local_from_base_prior.translation).norm();
    if (step.outcome == StepOutcome::kNoReturns || moved <= most) continue;
    found = i;
    most = moved;
  }
  return found;
}

void DrawAll(const Recording& recording, const std::string& folder) {
  const std::vector<DemoPicture> pictures = {
      {ViewKind::kMap, "all submaps at their optimized poses"},
      {ViewKind::kSubmap, "one probability grid and its scans"},
      {ViewKind::kUpdate, "what one scan hit and missed"},
      {ViewKind::kMatch, "the scan that its match moved most"},
      {ViewKind::kSearch, "one loop search: where it looked, what it pruned"},
      {ViewKind::kGraph, "nodes, submaps, constraints and residuals"}};
  Painter painter(Backend::kAuto);
  for (const DemoPicture& picture : pictures) {
    ViewRequest request;
    request.view = picture.view;
    if (picture.view == ViewKind::kMatch) request.step = StepMovedMost(recording);
    const std::string path = folder + "/" + ToString(picture.view) + ".png";
    WritePng(painter.Draw(recording, request), path);
    Tell(path, picture.what);
  }
}

void CompareWithTruth(const Recording& recording) {
  const Trajectory trajectory = DenseTrajectory(recording, StateOf(recording, std::nullopt));
  const RelationsError error =
      EvaluateRelations(ReadRelations(BesideLog(".relations")), trajectory);
  const auto absolute = EvaluateTrajectory(ReadTum(BesideLog(".tum")), trajectory);
  fmt::print(
      "The log is simulated, so the truth is known: {:.3f} m and {:.2f} deg off from place to "
      "place, {:.3f} m over all.\n",
      error.translation.mean, RadiansToDegrees(error.rotation.mean),
      absolute ? absolute->translation.rmse : 0.0);
}

int RunDemo(const DemoArguments& arguments) {
  const ScanLog log = ReadCarmenLog(LOOPSCOPE_DEMO_LOG);
  MakeFolder(arguments.folder);
  const std::string run = arguments.folder + "/office.loopscope";
  fmt::print("Mapping the bundled log, {} scans of a simulated office.\n", log.scans.size());
  std::fflush(stdout);
  const MappedFile mapped = MapToFile(log, LoopscopePreset(), DefaultNumThreads(), run);
  if (mapped.was_interrupted) return 1;
  fmt::print("In {}:\n", fs::absolute(arguments.folder).lexically_normal().string());
  Tell(run, "recording: look at it with loopscope info, render, why, ...");
  Export(mapped.recording, arguments.folder);
  DrawAll(mapped.recording, arguments.folder);
  CompareWithTruth(mapped.recording);
  return 0;
}

}  // namespace

void AddDemoCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command = app->add_subcommand(
      "demo", "Map the bundled log; leave recording, map, trajectory, graph and six pictures");
  const auto arguments = std::make_shared<DemoArguments>();
  command->add_option("-o,--output", arguments->folder, "Folder for all of it")
      ->type_name("FOLDER")
      ->capture_default_str();
  command->callback([arguments, exit_code] { *exit_code = RunDemo(*arguments); });
}

}  // namespace loopscope
