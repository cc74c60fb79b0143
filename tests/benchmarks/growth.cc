// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0

// What mapping costs as the map grows: maps a street of houses that the simulator made, and draws
// processor time and memory for a node.
//
//   growth KILOMETERS [PICTURE.png]

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <iostream>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/simulation/random.h"
#include "core/simulation/simulate.h"
#include "core/slam/slam.h"
#include "render/headless/painter.h"
#include "render/views/chart_drawing.h"
#include "render/views/sheet.h"

namespace loopscope {
namespace {

constexpr double kHouseLength = 20.0;  // [m]
constexpr double kHouseWidth = 14.0;   // [m]
constexpr double kCorridor = 2.2;      // [m]

/// A ring of corridors with cupboards, each house its own, and a door to the next.
void AddHouse(double x, bool is_first, Random* random, FloorPlan* plan) {
  plan->AddWall({x, 0.0}, {x + kHouseLength, 0.0});
  plan->AddWall({x, kHouseWidth}, {x + kHouseLength, kHouseWidth});
  if (is_first) plan->AddWall({x, 0.0}, {x, kHouseWidth});
  plan->AddWall({x + kHouseLength, 0.0}, {x + kHouseLength, kHouseWidth}, {{1.1, 1.4}});
  plan->AddRoom({x + kCorridor, kCorridor},
                {x + kHouseLength - kCorridor, kHouseWidth - kCorridor});
  for (int i = 0; i < 5; ++i) {
    const double place = x + 3.5 + 3.0 * i;
    plan->AddBox(Pose2(place, 0.2, 0.0), {random->Uniform(0.3, 1.6), random->Uniform(0.2, 0.5)});
    plan->AddBox(Pose2(place + random->Uniform(-0.8, 0.8), kHouseWidth - 0.2, 0.0),
                 {random->Uniform(0.3, 1.6), random->Uniform(0.2, 0.5)});
  }
  for (const double y : {4.0, 7.0, 10.0}) {
    plan->AddPillar({x + 0.2, y + random->Uniform(-1.0, 1.0)}, random->Uniform(0.1, 0.3));
    plan->AddPillar({x + kHouseLength - 0.2, y + random->Uniform(-1.0, 1.0)},
                    random->Uniform(0.1, 0.3));
  }
}

/// Twice round each house, then on to the next, for so many kilometres.
World StreetWorld(double kilometers) {
  constexpr double kWayInHouse = 139.0;  // [m]
  const int num_houses = std::max(1, static_cast<int>(1000.0 * kilometers / kWayInHouse + 0.5));
  World world;
  world.name = fmt::format("street of {} houses", num_houses);
  Random random(5);
  for (int i = 0; i < num_houses; ++i) {
    const double x = kHouseLength * i;
    AddHouse(x, i == 0, &random, &world.plan);
    const double left = x + 1.1;
    const double right = x + kHouseLength - 1.1;
    world.route.insert(world.route.end(), {{left, 1.1}, {right, 1.1}});
    for (int round = 0; round < 2; ++round) {
      world.route.insert(
          world.route.end(),
          {{right, kHouseWidth - 1.1}, {left, kHouseWidth - 1.1}, {left, 1.1}, {right, 1.1}});
    }
  }
  return world;
}

Simulation SimulateStreet(double kilometers) {
  SimulationOptions options;
  options.scan_period = 0.5;
  options.lidar.beams = {181, DegreesToRadians(-90.0), DegreesToRadians(1.0)};
  return Simulate(StreetWorld(kilometers), options);
}

double ProcessorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

double ResidentMegabytes() {
  std::ifstream file("/proc/self/statm");
  double total = 0.0;
  double resident = 0.0;
  file >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / 1e6;
}

/// The mean over some nodes that follow each other.
struct Sample {
  int num_nodes = 0;          ///< in the map at their end
  double milliseconds = 0.0;  ///< of processor time for a node
  double optimization = 0.0;  ///< the part of it that went into scans with an optimization
  double searches = 0.0;      ///< for a node
  double window = 0.0;        ///< [m] half the width of a search, each way
  double iterations = 0.0;    ///< of an optimization
  double error = 0.0;         ///< [m] of the last node, seen from the first
  double megabytes = 0.0;     ///< above those before the first scan, for a submap
};

struct Growth {
  std::vector<Sample> samples;
  double final_seconds = 0.0;  ///< of processor time in the last scan, with the final optimization
  double final_error = 0.0;    ///< [m] of the last node then, seen from the first
};

/// [m] of the last node, which is that of a scan at `time`, seen from the first.
double ErrorOf(const Optimization& optimization, const Trajectory& truth, double time) {
  const std::vector<Pose2>& nodes = optimization.global_from_node;
  const Pose2 mapped = nodes.front().Inverse() * nodes.back();
  const Pose2 exact = truth.front().map_from_base.Inverse() * PoseAt(truth, time);
  return (mapped.translation - exact.translation).norm();
}

void PrintRow(const Sample& s) {
  std::cout << fmt::format(
                   "{:5}  {:7.2f}  {:19.2f}  {:13.1f}  {:10.2f}  {:10.1f}  {:7.2f}  {:9.2f}",
                   s.num_nodes, s.milliseconds, s.optimization, s.searches, s.window, s.iterations,
                   s.error, s.megabytes)
            << std::endl;
}

/// Prints each sample when it is complete.
Growth MapAndMeasure(const Simulation& simulation) {
  const ScanLog& log = simulation.log;
  constexpr int kNodesOfSample = 250;
  std::cout << "nodes  ms/node  in optimizing scans  searches/node  window [m]  iterations  off "
               "[m]  MB/submap\n";
  Growth growth;
  const double megabytes_before = ResidentMegabytes();
  Slam slam(log, LoopscopePreset(), 1);
  int num_nodes = 0;
  int num_submaps = 0;
  int num_nodes_before = 0;
  double seconds = 0.0;
  double optimization_seconds = 0.0;
  int num_searches = 0;
  double windows = 0.0;  // [m]
  int num_optimizations = 0;
  int num_iterations = 0;
  for (int scan = 0; scan < static_cast<int>(log.scans.size()); ++scan) {
    const double before = ProcessorSeconds();
    const SlamUpdate update = slam.AddScan(scan);
    const double took = ProcessorSeconds() - before;
    if (scan + 1 == static_cast<int>(log.scans.size())) {
      growth.final_seconds = took;
      growth.final_error =
          ErrorOf(*update.optimization, simulation.ground_truth, log.scans[scan].time);
      break;
    }
    seconds += took;
    for (const LoopCandidate& candidate : update.candidates) {
      if (candidate.verdict == Verdict::kNotSampled) continue;
      ++num_searches;
      windows += candidate.linear_search_window;
    }
    if (update.optimization) {
      optimization_seconds += took;
      num_iterations += update.optimization->num_iterations;
      ++num_optimizations;
    }
    num_nodes += update.node ? 1 : 0;
    num_submaps += update.started_submap ? 1 : 0;
    const int count = num_nodes - num_nodes_before;
    if (count < kNodesOfSample || !update.optimization) continue;
    growth.samples.push_back(
        {num_nodes, 1e3 * seconds / count, 1e3 * optimization_seconds / count,
         static_cast<double>(num_searches) / count, windows / num_searches,
         static_cast<double>(num_iterations) / num_optimizations,
         ErrorOf(*update.optimization, simulation.ground_truth, log.scans[scan].time),
         (ResidentMegabytes() - megabytes_before) / num_submaps});
    PrintRow(growth.samples.back());
    num_nodes_before = num_nodes;
    seconds = optimization_seconds = windows = 0.0;
    num_searches = num_optimizations = num_iterations = 0;
  }
  return growth;
}

ChartSeries SeriesOf(const Growth& growth, ChartSubject subject, const std::string& name,
                     double Sample::*number) {
  ChartSeries series;
  series.subject = subject;
  series.name = name;
  series.joined = true;
  for (const Sample& sample : growth.samples) {
    series.points.push_back({static_cast<double>(sample.num_nodes), sample.*number});
  }
  return series;
}

ChartData ChartOf(const std::string& title, const std::string& unit,
                  std::vector<ChartSeries> series) {
  ChartData data;
  data.title = title;
  data.x = {"nodes", 0.0, series.front().points.back().x, false};
  double max = 0.0;
  for (const ChartSeries& s : series) {
    for (const ChartPoint& point : s.points) max = std::max(max, point.y);
  }
  data.y = {unit, 0.0, 1.1 * max, false};
  data.series = std::move(series);
  return data;
}

void WritePicture(const Growth& growth, const std::string& name, const std::string& path) {
  ViewRequest request;
  request.layers = {LayerKind::kGrid, LayerKind::kScan, LayerKind::kLabels};
  Annotation annotation;
  annotation.title = "What a node costs as the map grows";
  annotation.subtitle = {name};
  annotation.facts = {{"final optimization", fmt::format("{:.1f} s", growth.final_seconds)}};
  Arrangement arrangement;
  arrangement.num_side_panels = 1;
  const ChartData time =
      ChartOf("processor time for a node", "processor time for a node [ms]",
              {SeriesOf(growth, ChartSubject::kBefore, "time, all", &Sample::milliseconds),
               SeriesOf(growth, ChartSubject::kAfter, "time, searches and optimizations",
                        &Sample::optimization)});
  const ChartData memory =
      ChartOf("memory for a submap", "memory for a submap [MB]",
              {SeriesOf(growth, ChartSubject::kMean, "memory", &Sample::megabytes)});
  Painter painter(Backend::kAuto);
  Sheet sheet(request, 1, annotation, KeysOf({&time, &memory}, PaletteOf(request.theme)),
              arrangement);
  DrawChart(time, 0, sheet.OpenChart(0, {}), &sheet);
  DrawChart(memory, 1, sheet.OpenChart(1, {}), &sheet);
  WritePng(painter.Draw(sheet.Finish()), path);
}

int Run(int argc, char** argv) {
  if (argc < 2 || argc > 3 || std::atof(argv[1]) <= 0.0) {
    std::cerr << "usage: growth KILOMETERS [PICTURE.png]\n";
    return 2;
  }
  const Simulation simulation = SimulateStreet(std::atof(argv[1]));
  const Growth growth = MapAndMeasure(simulation);
  std::cout << fmt::format("last scan, with the final optimization: {:.1f} s, then {:.2f} m off\n",
                           growth.final_seconds, growth.final_error);
  if (argc == 3) WritePicture(growth, simulation.log.name, argv[2]);
  return 0;
}

}  // namespace
}  // namespace loopscope

int main(int argc, char** argv) { return loopscope::Run(argc, argv); }
