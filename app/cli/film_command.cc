// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdlib>
#include <future>
#include <malloc.h>
#include <memory>
#include <string>
#include <utility>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "app/cli/commands.h"
#include "app/cli/progress_bar.h"
#include "app/cli/run_arguments.h"
#include "app/cli/view_arguments.h"
#include "render/film.h"
#include "render/film_writer.h"

namespace loopscope {
namespace {

struct FilmArguments {
  std::string run;
  std::string steps;
  std::string output;
  double frames_per_second = 25.0;
  ViewArguments view;
};

/// Each frame takes the same large blocks of memory again. To give them back to the system in
/// between cost a fifth of the time.
void KeepFreedMemory() {
  constexpr int kBytes = 512 << 20;
  mallopt(M_MMAP_THRESHOLD, kBytes);
  mallopt(M_TRIM_THRESHOLD, kBytes);
}

struct Shot {
  int num_frames = 0;
  int num_left_out = 0;  ///< steps of which there is nothing to show
};

/// Fewer than there are steps if the user interrupted it. Throws NothingToShow if there is no frame
/// at all.
Shot Shoot(const Recording& recording, const FilmArguments& arguments, const StepRange& steps) {
  DerivedCache cache(recording);
  Painter painter(BackendFromName(arguments.view.picture.backend));
  ViewRequest request =
      WithCameraOf(&cache, ToRequest(arguments.view, recording), steps.step(steps.count() - 1));
  const auto film = MakeFilmWriter(arguments.output, arguments.frames_per_second);
  const InterruptGuard guard;
  ProgressBar bar;
  Shot shot;
  int done = 0;
  std::future<void> written;  // the frame before, while the next one is drawn
  while (done < steps.count() && !(shot.num_frames > 0 && InterruptGuard::interrupted())) {
    request.step = steps.step(done++);
    try {
      Picture picture = painter.Draw(&cache, request);
      if (written.valid()) written.get();
      written = std::async(std::launch::async,
                           [&film, picture = std::move(picture)] { film->Add(picture); });
      ++shot.num_frames;
    } catch (const NothingToShow&) {
      if (++shot.num_left_out == steps.count()) throw;
    }
    bar.Show(done, steps.count(), fmt::format("steps  {:.1f} steps/s", done / bar.seconds()));
  }
  bar.End();
  written.get();
  film->Finish();
  return shot;
}

int RunFilm(const FilmArguments& arguments) {
  constexpr int kKeepIfSet = 0;
  setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", kKeepIfSet);  // we tell ourselves what went wrong
  KeepFreedMemory();
  RequireFilmPath(arguments.output);  // before the work begins
  const Recording recording = ReadRun(arguments.run);
  const StepRange steps = ParseStepRange(arguments.steps, recording.num_steps());
  const Shot shot = Shoot(recording, arguments, steps);
  fmt::print("{}: {} frames, {:.1f} s{}\n", arguments.output, shot.num_frames,
             shot.num_frames / arguments.frames_per_second,
             shot.num_left_out > 0
                 ? fmt::format("; left out {} steps with nothing to show", shot.num_left_out)
                 : "");
  if (shot.num_frames + shot.num_left_out == steps.count()) return 0;
  fmt::print(stderr, "loopscope: interrupted; {} holds the frames until then\n", arguments.output);
  return 1;
}

}  // namespace

void AddFilmCommand(CLI::App* app, int* exit_code) {
  CLI::App* const command =
      app->add_subcommand("film", "Film how a recording came about, without a display");
  const auto arguments = std::make_shared<FilmArguments>();
  AddRunArgument(command, &arguments->run);
  command
      ->add_option("--steps", arguments->steps,
                   "Scans to show, every STRIDE-th, e.g. 0:500, or ::10 for every tenth of all")
      ->required()
      ->type_name("FIRST:LAST[:STRIDE]");
  command
      ->add_option("-o,--output", arguments->output,
                   "Video to write, .mp4 or .avi, or folder for frame_000000.png and so on")
      ->required()
      ->type_name("FILE");
  command->add_option("--fps", arguments->frames_per_second, "Frames per second of a video")
      ->check(RefuseNan)
      ->check(CLI::Range(1.0, 120.0))
      ->capture_default_str()
      ->type_name("N");
  AddViewArguments(command, &arguments->view);
  command->callback([arguments, exit_code] { *exit_code = RunFilm(*arguments); });
}

}  // namespace loopscope
