// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <vtkCamera.h>
#include <vtkRendererCollection.h>
#include <vtkUnsignedCharArray.h>

#include <benchmark/benchmark.h>

#include "render/headless/offscreen_window.h"
#include "render/inspection.h"
#include "tests/support/large_recording.h"

namespace loopscope {
namespace {

/// 10,000 nodes, 20,000 INTRA and 15,000 INTER constraints.
const Recording& LargeRecording() {
  static const Recording recording = LargeRun::Make(10000, 15000);
  return recording;
}

ViewRequest GraphRequest() {
  ViewRequest request;
  request.view = ViewKind::kGraph;
  return request;
}

vtkSmartPointer<OffscreenWindow> WindowWith(const Scene& scene) {
  auto window = vtkSmartPointer<OffscreenWindow>::New();
  window->Open(MakeGlContext(Backend::kOsmesa));
  window->SetSize(scene.width, scene.height);
  Show(scene, window);
  return window;
}

/// Draws a frame and waits until it is there.
void DrawFrame(vtkRenderWindow* window) {
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixel;
  window->GetPixelData(0, 0, 0, 0, 0, pixel, 0);
}

// A frame of a window of 1280 x 720 while the hand drags the graph.
void DragGraph(benchmark::State& state, bool moving) {
  const Scene scene = BuildScene(LargeRecording(), GraphRequest());
  const auto window = WindowWith(scene);
  SetMoving(scene.panels[0], moving);
  constexpr int kPanel = 1;  // the sheet comes first
  auto* const renderer = vtkRenderer::SafeDownCast(window->GetRenderers()->GetItemAsObject(kPanel));
  vtkCamera* const camera = renderer->GetActiveCamera();
  DrawFrame(window);
  double way = 0.0;
  for (auto _ : state) {
    way += 0.05;
    camera->SetPosition(way, 0.0, 1.0);
    camera->SetFocalPoint(way, 0.0, 0.0);
    DrawFrame(window);
  }
}

void BM_DragGraphAtRest(benchmark::State& state) { DragGraph(state, false); }
BENCHMARK(BM_DragGraphAtRest)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()  // OpenGL draws on threads of its own
    ->UseRealTime();

void BM_DragGraphMoving(benchmark::State& state) { DragGraph(state, true); }
BENCHMARK(BM_DragGraphMoving)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()  // OpenGL draws on threads of its own
    ->UseRealTime();

void BM_BuildGraph(benchmark::State& state) {
  DerivedCache cache(LargeRecording());
  BuildScene(&cache, GraphRequest());
  for (auto _ : state) benchmark::DoNotOptimize(BuildScene(&cache, GraphRequest()));
}
BENCHMARK(BM_BuildGraph)->Unit(benchmark::kMillisecond);

void BM_InspectGraph(benchmark::State& state) {
  DerivedCache cache(LargeRecording());
  const Inspector inspector(&cache, GraphRequest(), Scene());
  double x = 0.0;
  for (auto _ : state) benchmark::DoNotOptimize(inspector.WhatIsAt(0, {x += 1e-3, 0.1}, 0.01));
}
BENCHMARK(BM_InspectGraph)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace loopscope
