// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#include "app/session/command_groups.h"

namespace loopscope {
namespace {

/// A command that the program around the session carries out.
Command HostCommand(Command command, const std::function<void(SessionHost*)>& run) {
  command.run = [run](Session*, SessionHost* host, const std::string&) { run(host); };
  return command;
}

bool HasRecording(const Session& session) { return session.has_recording(); }

}  // namespace

std::vector<Command> FileCommands() {
  return {
      {"file.open",
       "Open a log or a recording…",
       "File",
       {"Ctrl+O"},
       "PATH",
       Always,
       [](Session*, SessionHost* host, const std::string& path) { host->Open(path); }},
      HostCommand({"file.demo", "Map the demo log", "File", {}, "", Always, {}},
                  [](SessionHost* host) { host->OpenDemo(); }),
      HostCommand({"file.map_again",
                   "Map again with other options…",
                   "File",
                   {"Ctrl+R"},
                   "",
                   HasRecording,
                   {}},
                  [](SessionHost* host) { host->MapAgain(); }),
      HostCommand({"file.stop_mapping", "Stop mapping", "File", {}, "", Always, {}},
                  [](SessionHost* host) { host->StopMapping(); }),
      {"file.export",
       "Export a picture or film…",
       "File",
       {"F12", "Ctrl+E"},
       "PATH",
       HasSteps,
       [](Session*, SessionHost* host, const std::string& path) { host->Export(path); }},
      HostCommand({"file.stop_export", "Stop exporting", "File", {}, "", Always, {}},
                  [](SessionHost* host) { host->StopExport(); }),
      HostCommand({"file.copy_command",
                   "Copy the command line of the picture",
                   "File",
                   {"Ctrl+Shift+C"},
                   "",
                   HasSteps,
                   {}},
                  [](SessionHost* host) { host->CopyCommandLine(); }),
      HostCommand({"file.quit", "Quit", "File", {"Ctrl+Q"}, "", Always, {}},
                  [](SessionHost* host) { host->Quit(); }),
  };
}

std::vector<Command> HelpCommands() {
  return {
      HostCommand({"help.palette", "Find a command…", "Help", {"Ctrl+P"}, "", Always, {}},
                  [](SessionHost* host) { host->ShowPalette(); }),
      HostCommand({"help.keys", "Keys", "Help", {"H", "?", "F1"}, "", Always, {}},
                  [](SessionHost* host) { host->ShowKeys(); }),
      HostCommand(
          {"window.reset_layout", "Docks as on the first day", "Window", {}, "", Always, {}},
          [](SessionHost* host) { host->ResetLayout(); }),
      HostCommand({"window.light", "Light window", "Window", {}, "", Always, {}},
                  [](SessionHost* host) { host->SetWindowTheme("light"); }),
      HostCommand({"window.dark", "Dark window", "Window", {}, "", Always, {}},
                  [](SessionHost* host) { host->SetWindowTheme("dark"); }),
  };
}

}  // namespace loopscope
