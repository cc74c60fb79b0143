// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <string>
#include <utility>

#include <benchmark/benchmark.h>

#include "core/io/carmen_log.h"
#include "core/io/recording_file.h"
#include "core/simulation/random.h"
#include "core/slam/slam.h"
#include "render/film.h"
#include "render/headless/painter.h"
#include "tests/support/datasets.h"
#include "tests/support/temporary_folder.h"

namespace loopscope {
namespace {

// What one waits for with a long recording: the public log `intel`, 9247 scans, which comes with
// the data sets.

std::string IntelLog() { return (DatasetsFolder() / "carmen/intel.log.gz").string(); }

struct Run {
  TemporaryFolder folder;
  std::string path = folder.Path("intel.loopscope");
  Recording recording;

  Run() : recording(ReadCarmenLog(IntelLog()), LoopscopePreset()) {
    RecordingWriter writer(path, recording.log(), recording.options());
    Slam slam(recording.log(), recording.options(), /*num_threads=*/2);
    for (int scan = 0; scan < static_cast<int>(recording.log().scans.size()); ++scan) {
      SlamUpdate update = slam.AddScan(scan);
      writer.Append(update);
      recording.Append(std::move(update));
    }
    writer.Finish(1.0);
  }
};

/// Null, with a line that says so, if the log is not there.
const Run* IntelRun(benchmark::State& state) {
  if (!std::filesystem::exists(IntelLog())) {
    state.SkipWithError((IntelLog() + " is absent, see LOOPSCOPE_DATASETS").c_str());
    return nullptr;
  }
  static const Run run;
  return &run;
}

void BM_OpenRecording(benchmark::State& state) {
  const Run* const run = IntelRun(state);
  if (run == nullptr) return;
  for (auto _ : state) benchmark::DoNotOptimize(ReadRecording(run->path));
}
BENCHMARK(BM_OpenRecording)->Unit(benchmark::kMillisecond);

void BuildAndDraw(const ViewRequest& request, bool draws, DerivedCache* cache, Painter* painter) {
  const Scene scene = BuildScene(cache, request, OversamplingOf(request));
  if (draws) benchmark::DoNotOptimize(painter->Draw(scene));
}

/// From any step to any other, in the map, as the window does it once it was idle for a while: what
/// it takes until the scene is there, and a picture of 1280 x 720 by OSMesa of it.
void BM_Seek(benchmark::State& state) {
  const Run* const run = IntelRun(state);
  if (run == nullptr) return;
  const bool draws = state.range(0) != 0;
  DerivedCache cache(run->recording);
  Painter painter(Backend::kOsmesa);
  ViewRequest request;
  BuildScene(&cache, request, OversamplingOf(request));
  while (cache.Prefetch()) {
  }
  Random random(1);
  for (auto _ : state) {
    request.step = random.Below(run->recording.num_steps());
    BuildAndDraw(request, draws, &cache, &painter);
  }
}
BENCHMARK(BM_Seek)
    ->ArgName("drawn")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

/// One more frame of a film of 1920 x 1080, of the map of some 100 submaps and more, without its
/// encoding.
void BM_FilmFrame(benchmark::State& state) {
  const Run* const run = IntelRun(state);
  if (run == nullptr) return;
  const bool draws = state.range(0) != 0;
  DerivedCache cache(run->recording);
  Painter painter(Backend::kOsmesa);
  ViewRequest request;
  request.width = 1920;
  request.height = 1080;
  const int last = run->recording.num_steps() - 1;
  request = WithCameraOf(&cache, request, last);
  const int first = last * 4 / 5;
  int step = first;
  const auto draw_next = [&] {
    request.step = step;
    step = step < last ? step + 1 : first;
    BuildAndDraw(request, draws, &cache, &painter);
  };
  for (int i = 0; i < 3; ++i) draw_next();  // until all is remembered
  for (auto _ : state) draw_next();
}
BENCHMARK(BM_FilmFrame)
    ->ArgName("drawn")
    ->Arg(0)
    ->Arg(1)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

}  // namespace
}  // namespace loopscope
