// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/commands.h"

namespace {

constexpr int kBadUsageOrInput = 2;

const char kDescription[] =
    "Loopscope maps 2D lidar logs and shows why a loop was closed, or was not.\n"
    "Try `loopscope demo`, or `loopscope map LOG -o RUN.loopscope` and then `loopscope render "
    "RUN.loopscope`.";

const char kFooter[] =
    "Exit codes: 0 fine, 1 the answer is \"no\" or a comparison failed, 2 bad usage or bad input.";

/// Of the command that was given, or of the program if that was none.
std::string HelpOf(const CLI::App& app) {
  const std::vector<CLI::App*> commands = app.get_subcommands();
  return commands.empty() ? "loopscope --help"
                          : "loopscope " + commands.front()->get_name() + " --help";
}

/// What is wrong with the arguments.
std::string WhyRefused(const CLI::App& app, const CLI::ParseError& error, int argc, char** argv) {
  const bool names_no_command = app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-';
  if (!names_no_command) return error.what();
  std::string names;
  for (const CLI::App* command : app.get_subcommands(nullptr)) {
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  return "no command '" + std::string(argv[1]) + "': expected " + names;
}

/// Throws if what was printed did not go where it should.
void FlushOutput() {
  errno = 0;
  std::cout.flush();
  if (std::fflush(stdout) == 0 && std::cout) return;
  throw std::runtime_error(std::string("standard output: cannot be written") +
                           (errno != 0 ? std::string(": ") + std::strerror(errno) : ""));
}

}  // namespace

int main(int argc, char** argv) {
  // A file that grows too large shall fail to be written, and be told of, like any other.
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app(kDescription, "loopscope");
  app.footer(kFooter);
  app.require_subcommand(1);
  app.set_version_flag("--version", std::string("loopscope ") + LOOPSCOPE_VERSION);
  int exit_code = 0;
  loopscope::AddMapCommand(&app, &exit_code);
  loopscope::AddInfoCommand(&app, &exit_code);
  loopscope::AddRenderCommand(&app, &exit_code);
  loopscope::AddFilmCommand(&app, &exit_code);
  loopscope::AddSearchCommand(&app, &exit_code);
  loopscope::AddWhyCommand(&app, &exit_code);
  loopscope::AddLoopsCommand(&app, &exit_code);
  loopscope::AddEvaluateCommand(&app, &exit_code);
  loopscope::AddExportCommand(&app, &exit_code);
  loopscope::AddSimulateCommand(&app, &exit_code);
  loopscope::AddOptionsCommand(&app, &exit_code);
  loopscope::AddDemoCommand(&app, &exit_code);
  try {
    app.parse(argc, argv);
    FlushOutput();
    return exit_code;
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);
    std::fprintf(stderr, "loopscope: %s (see %s)\n", WhyRefused(app, error, argc, argv).c_str(),
                 HelpOf(app).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "loopscope: %s\n", error.what());
  }
  return kBadUsageOrInput;
}
