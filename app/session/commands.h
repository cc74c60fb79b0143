// SPDX-FileCopyrightText: 2026 The Loopscope Authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/session/session.h"

namespace loopscope {

/// What commands ask of the program around a session: files, dialogs, the window. An empty
/// argument asks the person.
class SessionHost {
 public:
  virtual ~SessionHost() = default;

  /// Opens a recording, or maps a log.
  virtual void Open(const std::string& path) = 0;
  virtual void OpenDemo() = 0;
  /// Maps the log of the recording once more, with options that the person edits.
  virtual void MapAgain() = 0;
  virtual void StopMapping() = 0;
  /// Writes the picture of the active tile to `path`, or a film of it if the person wants one.
  virtual void Export(const std::string& path) = 0;
  virtual void StopExport() = 0;
  /// Puts the command line that draws the picture of the active tile into the clipboard.
  virtual void CopyCommandLine() = 0;
  virtual void ShowKeys() = 0;
  virtual void ShowPalette() = 0;
  virtual void SetWindowTheme(const std::string& name) = 0;
  /// Puts all docks back to where they were on the first day.
  virtual void ResetLayout() = 0;
  virtual void Quit() = 0;
};

/// One thing that a person can do. Menu, key, palette, script and test run the same one.
struct Command {
  std::string name;               ///< e.g. "step.next"
  std::string title;              ///< e.g. "Next scan"
  std::string menu;               ///< in which menu it stands; empty: in none
  std::vector<std::string> keys;  ///< e.g. "Ctrl+Right", as Qt spells them
  std::string argument;           ///< what it needs, e.g. "N"; empty: nothing
  std::function<bool(const Session&)> is_possible;
  /// Throws std::invalid_argument saying what was expected if the argument makes no sense.
  std::function<void(Session*, SessionHost*, const std::string& argument)> run;
};

/// All commands, in the order of menus and palette.
const std::vector<Command>& Commands();

/// Throws std::invalid_argument naming a near one if there is no such command.
const Command& CommandNamed(const std::string& name);

/// Runs a line such as "step.seek 120": a command and its argument. A command that is not possible
/// now changes nothing. Throws std::invalid_argument if there is none, or its argument is wrong.
void RunCommand(const std::string& line, Session* session, SessionHost* host);

/// Whether all words of `text` stand in title or name: "clo next" finds "Next closed loop".
bool MatchesPalette(const Command& command, const std::string& text);

}  // namespace loopscope
