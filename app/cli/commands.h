// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace loopscope {

// Each adds its subcommand to `app`. When the subcommand is run, what it returns is put into
// `exit_code`: 0 fine, 1 the answer is "no" or a comparison failed. Trouble is thrown.
void AddMapCommand(CLI::App* app, int* exit_code);
void AddInfoCommand(CLI::App* app, int* exit_code);
void AddRenderCommand(CLI::App* app, int* exit_code);
void AddFilmCommand(CLI::App* app, int* exit_code);
void AddSearchCommand(CLI::App* app, int* exit_code);
void AddWhyCommand(CLI::App* app, int* exit_code);
void AddLoopsCommand(CLI::App* app, int* exit_code);
void AddEvaluateCommand(CLI::App* app, int* exit_code);
void AddExportCommand(CLI::App* app, int* exit_code);
void AddSimulateCommand(CLI::App* app, int* exit_code);
void AddOptionsCommand(CLI::App* app, int* exit_code);
void AddDemoCommand(CLI::App* app, int* exit_code);

}  // namespace loopscope
